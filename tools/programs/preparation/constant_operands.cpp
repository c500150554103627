// Constant operands, for which glslang's constant folding is wrong:
//
// - fmod() and % of floats: fmod(-7, 2) is 1 and -7.5 % 2 is -7.5, where HLSL has -1 and -1.5;
// - < > <= >= of vectors: only the first components are compared;
// - any(), all() and dot() of numbers other than bools and floats;
// - comparisons and functions of matrices: out-of-bounds memory is read.
//
// One operand is passed through a function that returns it, which prevents folding in glslang; SPIRV-Tools
// folds the operation later, correctly. Linear time.

#include "preparation/passes.h"

#include "hlsl/declarations.h"
#include "hlsl/name_set.h"
#include "preparation/declarators.h"
#include "preparation/number_shape.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

constexpr std::string_view kIdentity = "penumbra_value";

// The kinds of tokens in an operand.
struct Operand {
  std::size_t first = npos;
  std::size_t end = npos;
  bool constant = false;
  bool fractional = false;  // it contains a float
  bool vector = false;      // it contains a vector or a matrix
  bool matrix = false;
};

class ConstantOperands {
 public:
  explicit ConstantOperands(TokenText& text)
      : text_(text), types_(text.types()), functions_(text.identifier_count(), false) {
    for (const FunctionType& function : types_.functions())
      if (function.name != npos && text_.is_identifier(function.name))
        functions_[text_.identifier_number(function.name)] = true;
  }

  void run() {
    for (std::size_t at = 1; at + 1 < text_.size(); ++at) {
      if (text_.is(at, "%")) {
        remainder(at);
      } else if (is_comparison(at)) {
        comparison(at);
      } else if (text_.is_identifier(at) && text_.is(at + 1, "(") && !text_.is(at - 1, ".")) {
        call(at);
      }
    }
    if (used_) text_.insert(0, definitions());
    text_.apply();
  }

 private:
  bool adjacent(std::size_t left) const {
    return left + 1 < text_.size() && text_.word(left).data() + 1 == text_.word(left + 1).data();
  }

  bool is_shift(std::size_t at) const {
    const auto twice = [&](std::size_t first) {
      return text_.is_any(first, "<", ">") && text_.lead(first) == text_.lead(first + 1) && adjacent(first);
    };
    return twice(at) || (at > 0 && twice(at - 1));
  }

  bool is_comparison(std::size_t at) const {
    const char mark = text_.lead(at);
    if (mark == '<' || mark == '>') return !is_shift(at);
    return (mark == '=' || mark == '!') && text_.is(at + 1, "=") && adjacent(at);
  }

  // Returns whether the left operand of a comparison or, with `factors`, of a % cannot extend to the left
  // over this token.
  bool ends_leftwards(std::size_t at, bool factors) const {
    const char mark = text_.lead(at);
    if (std::string_view("([{,;?:&|^=").find(mark) != std::string_view::npos) return true;
    if (mark == '<' || mark == '>') return factors || !is_shift(at);
    const bool binary =
        at > 0 && (text_.is_identifier(at - 1) || text_.is_number(at - 1) || text_.is_any(at - 1, ")", "]"));
    return (factors && binary && (mark == '+' || mark == '-')) || is_keyword(at);
  }

  bool ends_rightwards(std::size_t at, bool factors) const {
    const char mark = text_.lead(at);
    if (std::string_view(")]},;?:&|^=").find(mark) != std::string_view::npos) return true;
    if (mark == '<' || mark == '>') return factors || !is_shift(at);
    if (mark == '!' && text_.is(at + 1, "=")) return true;
    return factors && std::string_view("+-*/%").find(mark) != std::string_view::npos;
  }

  bool is_keyword(std::size_t at) const {
    static constexpr hlsl::NameSet keywords("return", "case", "else", "do");
    return text_.is_identifier(at) && keywords.contains(text_.word(at));
  }

  Operand left_of(std::size_t at, bool factors) const {
    std::size_t first = at;
    while (first > 0 && !ends_leftwards(first - 1, factors)) {
      --first;
      if (text_.is_any(first, ")", "]")) {
        if (text_.matching_bracket(first) == npos) return {};
        first = text_.matching_bracket(first);
      } else if (!may_be_constant(first)) {
        return {};  // it extends further, which does not matter
      }
    }
    return described(first, at);
  }

  Operand right_of(std::size_t at, bool factors) const {
    std::size_t end = at;
    while (end < text_.size() && (end == at || !ends_rightwards(end, factors))) {
      if (!may_be_constant(end)) return {};
      const bool opens = text_.is_any(end, "(", "[");
      if (opens && text_.matching_bracket(end) == npos) return {};
      end = opens ? text_.matching_bracket(end) + 1 : end + 1;
    }
    return described(at, end);
  }

  Operand described(std::size_t first, std::size_t end) const {
    Operand operand{first, end, end > first};
    for (std::size_t at = first; at < end && operand.constant; ++at) {
      operand.constant = may_be_constant(at);
      describe(at, operand);
    }
    return operand;
  }

  // Returns whether the token may belong to a constant: numbers, constants, numeric types, functions that are
  // not the text's, and what follows a '.'.
  bool may_be_constant(std::size_t at) const {
    if (!text_.is_identifier(at)) return !text_.is(at, "{");
    if (text_.is(at - 1, ".") || is_number_type(text_.word(at)) || text_.word(at) == "true" ||
        text_.word(at) == "false")
      return true;
    if (text_.is(at + 1, "(")) return !functions_[text_.identifier_number(at)];
    return types_.named(at) != npos && types_.declared()[types_.named(at)].type.constant;
  }

  void describe(std::size_t at, Operand& operand) const {
    if (text_.is_number(at))
      operand.fractional =
          operand.fractional || shape_of_number(text_.word(at)).base == NumberShape::Base::real;
    if (!text_.is_identifier(at)) return;
    const std::size_t named = types_.named(at);
    const std::string_view type = is_number_type(text_.word(at)) ? text_.word(at)
                                  : named != npos                ? types_.declared()[named].type.name
                                                                 : std::string_view{};
    const NumberShape shape = shape_of_type(type);
    operand.fractional = operand.fractional || shape.base == NumberShape::Base::real;
    operand.matrix = operand.matrix || shape.is_matrix();
    operand.vector = operand.vector || shape.is_vector() || shape.is_matrix();
  }

  void remainder(std::size_t at) {
    if (text_.is(at + 1, "=")) return;
    const Operand left = left_of(at, true);
    const Operand right = right_of(at + 1, true);
    if (left.constant && right.constant && (left.fractional || right.fractional)) hide(left);
  }

  void comparison(std::size_t at) {
    const std::size_t marks = text_.is(at + 1, "=") && adjacent(at) ? 2 : 1;
    const bool equality = text_.is_any(at, "=", "!");
    const Operand left = left_of(at, false);
    if (!left.constant) return;
    const Operand right = right_of(at + marks, false);
    const bool wrong = left.matrix || right.matrix || (!equality && (left.vector || right.vector));
    if (right.constant && wrong) hide(left);
  }

  void call(std::size_t name) {
    static constexpr hlsl::NameSet always("fmod", "dot", "any", "all");
    if (is_number_type(text_.word(name)) || is_keyword(name) || functions_[text_.identifier_number(name)])
      return;
    const std::size_t close = text_.matching_bracket(name + 1);
    if (close == npos || close == name + 2) return;
    const Operand all = described(name + 2, close);
    if (!all.constant || !(all.matrix || always.contains(text_.word(name)))) return;
    std::size_t end = name + 2;
    while (end < close && !text_.is(end, ","))
      end = text_.matching_bracket(end) != npos && text_.matching_bracket(end) > end
                ? text_.matching_bracket(end) + 1
                : end + 1;
    hide({name + 2, end});
  }

  void hide(const Operand& operand) {
    text_.insert(operand.first, std::string(kIdentity) + "(");
    text_.insert(operand.end, ")");
    used_ = true;
  }

  static std::string definitions() {
    std::string all;
    const auto define = [&](const std::string& type) {
      all += type + " " + std::string(kIdentity) + "(" + type + " x) { return x; } ";
    };
    for (const char* base : {"float", "int", "uint", "bool"})
      for (const char* size : {"", "2", "3", "4"}) define(std::string(base) + size);
    for (const char* shape : {"2x2", "2x3", "2x4", "3x2", "3x3", "3x4", "4x2", "4x3", "4x4"})
      for (const char* base : {"float", "int", "uint"}) define(std::string(base) + shape);
    return all + "\n";
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<bool> functions_;  // for each identifier number: a function of the text has that name
  bool used_ = false;
};

}  // namespace

void hide_constant_operands(TokenText& text) {
  ConstantOperands(text).run();
}

}  // namespace penumbra::preparation
