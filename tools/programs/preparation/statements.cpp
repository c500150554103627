#include <algorithm>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"
#include "preparation/expression_reader.h"
#include "preparation/passes.h"
#include "preparation/postfix_expression.h"
#include "preparation/resource_types.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

void wrap_in(TokenText& text, const hlsl::Declaration& function) {
  for (std::size_t at = function.open + 1; at < function.close; ++at) {
    if (!text.is_identifier(at) || !text.is(at + 1, "(") || !is_number_type(text.word(at))) continue;
    if (!begins_statement(text, at)) continue;
    const std::size_t end = expression_end(text, at);
    if (end == npos || !text.is(end, ";")) continue;
    text.insert(at, "(");
    text.insert(end, ")");
    at = end;
  }
}

// Finds the shapes of the values of switch statements.
class SwitchValues final : public ExpressionReader {
 public:
  explicit SwitchValues(const TokenText& text) : ExpressionReader(text), text_(text) {}

  std::vector<std::size_t> of_floats;  // the '(' of each

 private:
  void read_binary(const ReadOperand&, std::size_t, const ReadOperand&) override {}
  void read_parenthesised(std::size_t open, const NumberShape& inside) override {
    const bool is_switch = open > 0 && text_.is(open - 1, "switch");
    if (is_switch && inside.is_scalar() && inside.base == NumberShape::Base::real) of_floats.push_back(open);
  }

  const TokenText& text_;
};

bool is_storage(const TokenText& text, std::size_t at) {
  return text.is_any(at, "static", "inline", "precise", "const");
}

bool returns(const TokenText& text, const hlsl::Declaration& function) {
  return text.has(function.open, function.close, "return");
}

// Returns whether the name occurs outside of the function's definition.
bool is_mentioned(const TokenText& text, const hlsl::Declaration& function) {
  for (std::size_t at = 0; at < text.size(); ++at)
    if (at != function.name && text.is(at, text.word(function.name))) return true;
  return false;
}

// A texture or sampler has no zero value; such a function can only be removed.
void drop_unused(TokenText& text, const hlsl::Declaration& function) {
  if (is_mentioned(text, function)) return;
  text.note(
      function.name, hlsl::Severity::note,
      "'" + text.name(function.name) + "' has no return statement; nothing calls it, and it is left out");
  text.erase(function.first, function.last - function.first + 1);
}

class LoopVariables {
 public:
  explicit LoopVariables(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    if (!find_uses()) return;
    for (std::size_t at = 1; at + 1 < text_.size(); ++at)
      if (text_.is(at, "for") && text_.is(at + 1, "(") && text_.matching_bracket(at + 1) != npos) find(at);
    if (loops_.empty()) return;
    for (const Loop& loop : loops_) move_declaration(loop);
    rename();
    text_.apply();
  }

 private:
  // A loop whose variable is read after it.
  struct Loop {
    std::size_t place;  // the token before which the declaration is inserted
    std::size_t first;  // first token of the declaration
    std::size_t semicolon;
    std::size_t end;  // its last token
  };

  // Finds the last use of each declared value. Returns false if there is no local variable.
  bool find_uses() {
    last_use_.assign(types_.declared().size(), 0);
    for (std::size_t at = 0; at < text_.size(); ++at)
      if (types_.named(at) != npos) last_use_[types_.named(at)] = at;
    return !last_use_.empty();
  }

  void find(std::size_t at) {
    const std::size_t semicolon = expression_end(text_, at + 2);
    if (semicolon == npos || !text_.is(semicolon, ";")) return;
    const Loop loop{before_attributes(at), at + 2, semicolon,
                    statement_end(text_.matching_bracket(at + 1) + 1)};
    const std::vector<std::size_t> variables = declared_in(loop);
    const bool outlives = std::any_of(variables.begin(), variables.end(),
                                      [&](std::size_t variable) { return last_use_[variable] > loop.end; });
    if (!outlives || !stands_in_block(loop.place)) return;
    loops_.push_back(loop);
    for (const std::size_t variable : variables) loop_of_[variable] = loops_.size() - 1;
  }

  std::vector<std::size_t> declared_in(const Loop& loop) const {
    std::vector<std::size_t> variables;
    for (std::size_t name = loop.first; name < loop.semicolon; ++name) {
      const std::size_t index = types_.named(name);
      if (index != npos && types_.declared()[index].name == name) variables.push_back(index);
    }
    return variables;
  }

  std::string new_name(std::size_t variable) const {
    const std::size_t name = types_.declared()[variable].name;
    // The name is unique among all loops: the token's index is part of it.
    return text_.free_name(text_.name(name) + "_of_loop" + std::to_string(name));
  }

  void move_declaration(const Loop& loop) {
    std::string moved;
    for (std::size_t at = loop.first; at < loop.semicolon; ++at)
      moved +=
          (loop_of_.count(types_.named(at)) != 0 ? new_name(types_.named(at)) : text_.spelled(at, 1)) + " ";
    text_.insert_from(loop.first, loop.place, moved + "; ");
    text_.erase(loop.first, loop.semicolon - loop.first);
  }

  void rename() {
    std::size_t next = 0;
    for (std::size_t at = 0; at < text_.size(); ++at) {
      while (next < loops_.size() && loops_[next].semicolon <= at) ++next;
      const bool moved = next < loops_.size() && loops_[next].first <= at;
      const auto loop = moved ? loop_of_.end() : loop_of_.find(types_.named(at));
      if (loop == loop_of_.end()) continue;
      text_.replace(at, 1, new_name(loop->first));
      if (at > loops_[loop->second].end && hides_another(loop->first)) warn(at);
    }
  }

  // Returns whether the loop stands in the scope of another variable of that name.
  bool hides_another(std::size_t variable) const {
    const DeclaredValue& own = types_.declared()[variable];
    const std::uint32_t name = text_.identifier_number(own.name);
    for (std::size_t at = own.name; at-- > 0;) {
      if (text_.is(at, "}") && text_.matching_bracket(at) != npos) {
        at = text_.matching_bracket(at);
      } else if (text_.identifier_number(at) == name && types_.named(at) != npos &&
                 types_.named(at) != variable) {
        return !belongs_to_loop(types_.named(at));
      }
    }
    return false;
  }

  bool belongs_to_loop(std::size_t variable) const {
    const std::size_t first = types_.declared()[variable].first;
    return first != npos && first >= 2 && text_.is(first - 2, "for");
  }

  void warn(std::size_t at) {
    const std::string name = text_.name(at);
    text_.warn(
        at, "'" + name +
                "' here refers to the variable of the loop above, not to the one declared before the loop; " +
                "rename the loop's variable");
  }

  // Returns one past the statement that begins here.
  std::size_t statement_end(std::size_t at) const {
    at = text_.after_subscripts(at);
    if (text_.is(at, "{"))
      return text_.matching_bracket(at) == npos ? text_.size() : text_.matching_bracket(at);
    const bool headed = text_.is_any(at, "for", "while", "if");
    if (headed && text_.is(at + 1, "(") && text_.matching_bracket(at + 1) != npos) {
      const std::size_t end = statement_end(text_.matching_bracket(at + 1) + 1);
      return text_.is(at, "if") && text_.is(end + 1, "else") ? statement_end(end + 2) : end;
    }
    const std::size_t end = expression_end(text_, at);
    return end == npos ? text_.size() : end;
  }

  std::size_t before_attributes(std::size_t at) const {
    while (at > 0 && text_.is(at - 1, "]") && text_.matching_bracket(at - 1) != npos)
      at = text_.matching_bracket(at - 1);
    return at;
  }

  bool stands_in_block(std::size_t at) const { return at > 0 && text_.is_any(at - 1, "{", "}", ";"); }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<std::size_t> last_use_;
  std::vector<Loop> loops_;                               // loops in the order of the text
  std::unordered_map<std::size_t, std::size_t> loop_of_;  // for a declared value: index into loops_
};

}  // namespace

// A statement that begins with a constructor, `float3(1, 2, 3);` or `half4(a) * f(b);`: HLSL evaluates and
// discards it; glslang parses the beginning of a declaration. It is put in parentheses, so calls in it are
// still executed.
void wrap_constructor_statements(TokenText& text) {
  for (const hlsl::Declaration& declaration : text.declarations())
    if (declaration.kind == hlsl::Declaration::Kind::function) wrap_in(text, declaration);
  text.apply();
}

// In `switch (h)` with a half or float, HLSL truncates the value, while glslang accepts only integers. The
// value is cast to int if its type is known.
void cast_switch_values(TokenText& text) {
  bool has_switch = false;
  for (std::size_t at = 0; at < text.size() && !has_switch; ++at) has_switch = text.is(at, "switch");
  if (!has_switch) return;
  SwitchValues values(text);
  values.read_all();
  for (const std::size_t open : values.of_floats) {
    text.insert(open + 1, "(int)(");
    text.insert(text.matching_bracket(open), ")");
  }
  text.apply();
}

// A function with a return type and no return statement, because all of its returns are in branches of
// disabled keywords. Unity's compilers accept it if nothing calls it; glslang reports "must return a value".
// It returns zero instead, with a note; a function of texture or sampler type, for which there is no zero, is
// removed if its name is not used elsewhere. A function that returns on some paths is left to the compilers.
void return_from_empty_functions(TokenText& text) {
  for (const hlsl::Declaration& declaration : text.declarations()) {
    if (declaration.kind != hlsl::Declaration::Kind::function) continue;
    std::size_t type = declaration.type;
    while (is_storage(text, type)) ++type;
    if (text.is(type, "void") || returns(text, declaration)) continue;
    if (is_resource(text.word(type))) {
      drop_unused(text, declaration);
      continue;
    }
    text.note(declaration.name, hlsl::Severity::note,
              "'" + text.name(declaration.name) + "' has no return statement; it returns 0 here");
    text.insert(declaration.close, "return (" + text.spelled(type, declaration.name - type) + ")0;");
  }
  text.apply();
}

// A `for` loop's variable that is read after the loop: in Unity's compiler it belongs to the block that
// contains the loop (warning X3078), in glslang its scope is the loop. `for (int i = 0; i < n; ++i) { }
// use(i);` becomes `int i_of_loop = 0; for (; i_of_loop < n; ++i_of_loop) { } use(i_of_loop);`.
//
// If the block has another variable of that name, uses after the loop refer to the loop's variable, as that
// warning says; a warning reports it. A loop that is the body of an if or of a loop, without braces, is not
// changed.
void keep_loop_variables(TokenText& text) {
  LoopVariables(text).run();
}

}  // namespace penumbra::preparation
