// Structured and byte address buffers in a local variable or a member of a struct. In HLSL these are aliases
// of a buffer that must be known at compile time; glslang cannot assign buffers at all ("could not create
// assignment", "buffer aliasing not yet supported"), but passes them to functions correctly.
//
// Everything that is assigned to such a variable or member is traced, through parameters and other such
// variables, to the global buffers it comes from. If there is only one, its name replaces every use of the
// variable or member, and declarations and assignments are removed. If a member is read before the buffer's
// declaration, the declaration moves before the function that reads it.
//
// Limits: in the whole text, a member is an alias of one buffer; if two structs of a type contain different
// buffers, an error names them and suggests passing the buffer as an argument. Array elements, initialiser
// lists and buffers that a function returns are not traced.

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "preparation/passes.h"
#include "preparation/resource_types.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

using Place = DeclaredValue::Place;

// A declared value `to` that becomes an alias of the declared value `from`: by an assignment, an initialiser
// or as an argument.
struct Assignment {
  std::size_t to = npos;
  std::size_t from = npos;
};

struct TokenRange {
  std::size_t first = npos;
  std::size_t last = npos;
};

class Aliases {
 public:
  explicit Aliases(TokenText& text)
      : text_(text), types_(text.types()), stands_for_(types_.declared().size(), npos) {}

  void run() {
    const auto& declared = types_.declared();
    const bool any = std::any_of(declared.begin(), declared.end(),
                                 [](const DeclaredValue& value) { return is_alias(value); });
    if (!any) return;
    find_functions();
    find_inner_names();
    for (std::size_t at = 0; at < text_.size(); ++at) find_assignment(at);
    find_arguments();
    follow();
    report();
    for (std::size_t index = 0; index < declared.size(); ++index)
      if (is_resolved(index)) drop_declaration(declared[index]);
    std::sort(gone_.begin(), gone_.end(),
              [](const TokenRange& a, const TokenRange& b) { return a.first < b.first; });
    for (const TokenRange& range : gone_) text_.erase(range.first, range.last - range.first + 1);
    for (std::size_t at = 0; at < text_.size(); ++at) replace_use(at);
    for (const auto& [buffer, use] : first_uses_) declare_before(buffer, use);
    text_.apply();
  }

 private:
  static constexpr std::size_t several = npos - 1;

  const DeclaredValue& declared(std::size_t index) const { return types_.declared()[index]; }

  static bool is_alias(const DeclaredValue& value) {
    const bool variable = value.place == Place::local || value.place == Place::member || value.is_static;
    return variable && is_buffer(value.type.name) && value.type.dimensions == 0;
  }
  bool is_resolved(std::size_t index) const {
    return is_alias(declared(index)) && stands_for_[index] != npos && stands_for_[index] != several;
  }

  // Returns the whole buffer that the chain which ends here refers to; npos for everything else.
  std::size_t buffer_at(std::size_t last) const {
    if (last >= text_.size() || !text_.is_identifier(last) || types_.begin(last) == npos) return npos;
    const std::size_t index = types_.named(last);
    return index != npos && is_buffer(declared(index).type.name) ? index : npos;
  }

  // Finds `a.b = c;` and `T b = c;`, at the name before the '='.
  void find_assignment(std::size_t at) {
    if (!text_.is(at + 1, "=") || text_.is(at + 2, "=")) return;
    const std::size_t to = text_.is_identifier(at) ? types_.named(at) : npos;
    if (to == npos || !is_alias(declared(to))) return;
    std::size_t end = at + 2;
    while (end < text_.size() && !text_.is_any(end, ";", ",")) ++end;
    const std::size_t from = buffer_at(end - 1);
    if (from == npos || types_.begin(end - 1) != at + 2) return;
    assignments_.push_back({to, from});
    const bool initialiser = declared(to).name == at;
    if (!initialiser) gone_.push_back({types_.begin(at), end - 1});
  }

  void find_functions() {
    for (const FunctionType& function : types_.functions())
      functions_[text_.word(function.name)].push_back(&function);
  }

  // A parameter becomes an alias of its argument.
  void find_arguments() {
    struct Open {
      std::size_t bracket;
      std::size_t argument;
    };
    std::vector<Open> open;
    for (std::size_t at = 0; at < text_.size(); ++at) {
      const std::size_t match = text_.matching_bracket(at);
      if (match != npos && match > at) open.push_back({at, 0});
      if (match != npos && match < at && !open.empty()) open.pop_back();
      if (open.empty()) continue;
      if (text_.is(at, ",")) ++open.back().argument;
      const std::size_t from = buffer_at(at);
      const std::size_t bracket = open.back().bracket;
      if (from == npos || !text_.is(bracket, "(") || bracket == 0) continue;
      if (!text_.is_any(at + 1, ",", ")")) continue;
      const auto callees = functions_.find(text_.word(bracket - 1));
      if (callees == functions_.end()) continue;
      for (const FunctionType* callee : callees->second) give(*callee, open.back().argument, from);
    }
  }

  void give(const FunctionType& callee, std::size_t argument, std::size_t from) {
    if (argument >= callee.parameters.size()) return;
    const std::size_t parameter = callee.parameters[argument];
    if (declared(parameter).type.name == declared(from).type.name) assignments_.push_back({parameter, from});
  }

  // Propagates from the globals along the assignments; each value changes at most twice: to one buffer, then
  // to several.
  void follow() {
    std::multimap<std::size_t, std::size_t> targets;
    std::vector<std::size_t> open;
    for (const Assignment& assignment : assignments_) {
      targets.emplace(assignment.from, assignment.to);
      const DeclaredValue& from = declared(assignment.from);
      const bool source = from.place == Place::global && !from.is_static;
      if (source && stands_for_[assignment.from] == npos) {
        stands_for_[assignment.from] = assignment.from;
        open.push_back(assignment.from);
      }
    }
    for (std::size_t next = 0; next < open.size(); ++next) {
      const std::size_t from = open[next];
      const auto [first, last] = targets.equal_range(from);
      for (auto target = first; target != last; ++target)
        if (join(target->second, stands_for_[from])) open.push_back(target->second);
    }
  }

  bool join(std::size_t to, std::size_t buffer) {
    std::size_t& known = stands_for_[to];
    if (known == buffer || known == several) return false;
    if (known != npos && buffer != several && is_alias(declared(to))) others_[to] = {known, buffer};
    known = known == npos ? buffer : several;
    return true;
  }

  void report() {
    for (std::size_t index = 0; index < types_.declared().size(); ++index) {
      const DeclaredValue& value = declared(index);
      if (!is_alias(value)) continue;
      if (stands_for_[index] == several) {
        const auto two = others_.find(index);
        const std::string which = two == others_.end() ? "several buffers"
                                                       : "'" + name_of(two->second.first) + "' and of '" +
                                                             name_of(two->second.second) + "'";
        text_.error(value.name, "'" + name_of(index) + "' is an alias of " + which +
                                    " in different places; pass the buffer as a separate argument instead");
      } else if (is_resolved(index) && is_hidden(stands_for_[index])) {
        text_.error(value.name,
                    "'" + name_of(index) + "' is an alias of '" + name_of(stands_for_[index]) +
                        "', which is also the name of a parameter or local variable; rename that one");
      }
    }
  }

  std::string name_of(std::size_t index) const { return text_.name(declared(index).name); }

  bool is_hidden(std::size_t buffer) const {
    return inner_names_.count(text_.word(declared(buffer).name)) != 0;
  }

  void find_inner_names() {
    for (const DeclaredValue& value : types_.declared()) {
      const bool inner = value.place == Place::local || value.place == Place::parameter;
      if (inner && value.name != npos) inner_names_.insert(text_.word(value.name));
    }
  }

  void drop_declaration(const DeclaredValue& value) {
    if (value.first == npos) return;  // moved with the first declarator of its statement
    std::size_t end = value.last;
    while (end < text_.size() && !text_.is(end, ";")) ++end;
    gone_.push_back({value.first, end});
  }

  void replace_use(std::size_t at) {
    const std::size_t index = text_.is_identifier(at) ? types_.named(at) : npos;
    if (index == npos || !is_resolved(index) || declared(index).name == at) return;
    if (types_.begin(at) == npos || is_gone(at)) return;
    text_.replace(types_.begin(at), at - types_.begin(at) + 1, name_of(stands_for_[index]));
    first_uses_.emplace(stands_for_[index], at);
  }

  // A buffer that is declared after its first use moves, with its whole statement, before the function that
  // contains the use. Its element type is declared there, because the alias has the same type.
  void declare_before(std::size_t buffer, std::size_t use) {
    const hlsl::Declaration* statement = declaration_with(declared(buffer).name);
    const hlsl::Declaration* user = declaration_with(use);
    if (statement == nullptr || user == nullptr || statement->first < use) return;
    if (statement->scope != user->scope || !moved_.insert(statement->first).second) return;
    const std::size_t count = statement->last - statement->first + 1;
    text_.insert_from(statement->first, user->first, text_.spelled(statement->first, count));
    text_.erase(statement->first, count);
  }

  const hlsl::Declaration* declaration_with(std::size_t token) const {
    const auto& declarations = types_.declarations();
    const auto after = std::upper_bound(
        declarations.begin(), declarations.end(), token,
        [](std::size_t at, const hlsl::Declaration& declaration) { return at < declaration.first; });
    return after == declarations.begin() || std::prev(after)->last < token ? nullptr : &*std::prev(after);
  }

  bool is_gone(std::size_t at) const {
    const auto after =
        std::upper_bound(gone_.begin(), gone_.end(), at,
                         [](std::size_t token, const TokenRange& range) { return token < range.first; });
    return after != gone_.begin() && at <= std::prev(after)->last;
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::map<std::string_view, std::vector<const FunctionType*>> functions_;
  std::set<std::string_view> inner_names_;  // names of parameters and local variables
  std::vector<Assignment> assignments_;
  std::vector<TokenRange> gone_;         // assignments without their ';', and declarations
  std::vector<std::size_t> stands_for_;  // for each declared value: a global buffer, npos, or `several`
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> others_;
  std::map<std::size_t, std::size_t>
      first_uses_;               // for each buffer: the first place where its name was inserted
  std::set<std::size_t> moved_;  // first tokens of statements that were moved before their use
};

}  // namespace

void resolve_buffer_aliases(TokenText& text) {
  Aliases(text).run();
}

}  // namespace penumbra::preparation
