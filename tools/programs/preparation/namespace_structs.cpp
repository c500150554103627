// Variables and structs with member functions inside a namespace: glslang declares them under one name and
// looks them up under another ("no matching overloaded function found"). If a text has one, all its
// namespaces are replaced by prefixes: A::B::f becomes A_B_f, in its declaration, in qualified names, and in
// unqualified uses within the namespace. Members of structs keep their names.

#include "preparation/passes.h"

#include <algorithm>
#include <map>
#include <set>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"

namespace penumbra::preparation {

namespace {

using Kind = hlsl::Declaration::Kind;

class Namespaces {
 public:
  explicit Namespaces(TokenText& text) : text_(text), declarations_(text.declarations()) {}

  void run() {
    if (std::none_of(declarations_.begin(), declarations_.end(),
                     [this](const hlsl::Declaration& d) { return !d.scope.empty() && is_lost(d); }))
      return;
    for (const hlsl::Declaration& declaration : declarations_) declare(declaration);
    for (at_ = 0; at_ < text_.size(); ++at_) step();
    text_.apply();
  }

 private:
  // glslang does not find variables, nor the functions of structs, from within their namespace.
  bool is_lost(const hlsl::Declaration& declaration) const {
    return declaration.kind == Kind::variable || declaration.kind == Kind::buffer ||
           has_functions(declaration);
  }

  bool has_functions(const hlsl::Declaration& declaration) const {
    if (declaration.kind != Kind::structure) return false;
    return text_.has(declaration.open + 1, declaration.close, "(");
  }

  // Turns "A::B::" + name into "A_B_name".
  void declare_name(const std::string& scope, std::size_t at) {
    const std::string name = text_.name(at);
    std::string written;
    for (std::size_t i = 0; i < scope.size(); ++i) {
      if (scope[i] == ':') ++i;
      written += scope[i] == ':' ? '_' : scope[i];
    }
    names_[scope + name] = written + name;
  }

  void declare(const hlsl::Declaration& declaration) {
    if (declaration.scope.empty()) return;
    if (declaration.kind == Kind::variable) {
      for (const Declarator& declarator : declarators(text_, declaration.type, declaration.last))
        declare_name(declaration.scope, declarator.name);
    } else if (declaration.kind == Kind::alias && text_.is_identifier(declaration.last - 1)) {
      declare_name(declaration.scope, declaration.last - 1);
    } else if (declaration.name != hlsl::Declaration::none) {
      declare_name(declaration.scope, declaration.name);
    }
    if (declaration.kind == Kind::buffer) declare_members(declaration);
    if (declaration.kind == Kind::structure) note_members(declaration);
  }

  void declare_members(const hlsl::Declaration& buffer) {
    std::size_t first = buffer.open + 1;
    for (std::size_t at = first; at < buffer.close; ++at) {
      if (!text_.is(at, ";")) continue;
      for (const Declarator& declarator : declarators(text_, first, at))
        declare_name(buffer.scope, declarator.name);
      first = at + 1;
    }
  }

  // Records the member functions that a struct's own functions call by unqualified name.
  void note_members(const hlsl::Declaration& structure) {
    std::set<std::string_view>& members = members_[structure.open];
    for (std::size_t at = structure.open + 1; at < structure.close; ++at) {
      const bool named = text_.is_identifier(at) && text_.is_identifier(at - 1) &&
                         (text_.is_any(at + 1, ";", "(", "[", ",", ":"));
      if (named) members.insert(text_.word(at));
      const bool inside_function = text_.is_any(at, "{", "(");
      if (inside_function && text_.matching_bracket(at) != npos) at = text_.matching_bracket(at);
    }
  }

  void step() {
    if (text_.is(at_, "namespace") && text_.is_identifier(at_ + 1) && text_.is(at_ + 2, "{") &&
        text_.matching_bracket(at_ + 2) != npos) {
      scopes_.push_back({scope() + text_.name(at_ + 1) + "::", text_.matching_bracket(at_ + 2)});
      text_.erase(at_, 3);
      at_ += 2;
    } else if (!scopes_.empty() && at_ == scopes_.back().close) {
      text_.erase(at_, 1);
      scopes_.pop_back();
    } else if (const auto members = members_.find(at_); members != members_.end()) {
      structs_.push_back({&members->second, text_.matching_bracket(at_)});
    } else if (!structs_.empty() && at_ == structs_.back().close) {
      structs_.pop_back();
    } else if (text_.is_identifier(at_)) {
      name();
    }
  }

  std::string scope() const { return scopes_.empty() ? std::string() : scopes_.back().name; }

  // Reads a name, unqualified or qualified: `f`, `B::f`.
  void name() {
    if (text_.is(at_ - 1, ".") && at_ > 0) return;
    std::size_t end = at_ + 1;
    std::string asked = text_.name(at_);
    while (text_.is(end, ":") && text_.is(end + 1, ":") && text_.is_identifier(end + 2)) {
      asked += "::" + text_.name(end + 2);
      end += 3;
    }
    const bool member = end == at_ + 1 && std::any_of(structs_.begin(), structs_.end(), [&](const Struct& s) {
                          return s.members->count(text_.word(at_)) != 0;
                        });
    if (!member) write(asked, end);
    at_ = end - 1;
  }

  // The name is searched from the innermost namespace outwards; for `A::S::f` A::S is searched, too.
  void write(const std::string& asked, std::size_t end) {
    std::string around = scope();
    while (true) {
      std::string rest;
      std::string head = asked;
      while (true) {
        const auto found = names_.find(around + head);
        if (found != names_.end()) {
          text_.replace(at_, end - at_, found->second + rest);
          return;
        }
        const std::size_t colons = head.rfind("::");
        if (colons == std::string::npos) break;
        rest.insert(0, head, colons);
        head.erase(colons);
      }
      if (around.empty()) return;
      const std::size_t outer = around.size() > 2 ? around.rfind("::", around.size() - 3) : std::string::npos;
      around = outer == std::string::npos ? std::string() : around.substr(0, outer + 2);
    }
  }

  struct Scope {
    std::string name;  // "A::B::"
    std::size_t close;
  };
  struct Struct {
    const std::set<std::string_view>* members;
    std::size_t close;
  };

  TokenText& text_;
  const std::vector<hlsl::Declaration>& declarations_;
  std::map<std::string, std::string> names_;                   // "A::f" -> "A_f"
  std::map<std::size_t, std::set<std::string_view>> members_;  // by the '{' of their struct
  std::vector<Scope> scopes_;
  std::vector<Struct> structs_;
  std::size_t at_ = 0;
};

}  // namespace

void write_out_namespaces(TokenText& text) {
  Namespaces(text).run();
}

}  // namespace penumbra::preparation
