#include <algorithm>
#include <set>

#include "preparation/declarators.h"
#include "preparation/expression_reader.h"
#include "preparation/postfix_expression.h"
#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

bool is_integer(std::string_view number) {
  const bool hexadecimal = number.starts_with("0x") || number.starts_with("0X");
  if (hexadecimal) number.remove_prefix(2);
  while (!number.empty() && std::string_view("uUlL").find(number.back()) != std::string_view::npos)
    number.remove_suffix(1);
  return !number.empty() && std::all_of(number.begin(), number.end(), [&](char c) {
    return (c >= '0' && c <= '9') || (hexadecimal && ((c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F')));
  });
}

bool is_zero_literal(std::string_view number) {
  return is_integer(number) && number.find_first_of("123456789abcdefABCDEF") == std::string_view::npos;
}

class ConstantDivisions {
 public:
  explicit ConstantDivisions(TokenText& text) : text_(text) {}

  void run() {
    for (std::size_t at = 1; at + 1 < text_.size(); ++at)
      if (text_.is_any(at, "/", "%")) divide(at);
  }

 private:
  void divide(std::size_t at) {
    const std::size_t divisor = at + 1;
    if (text_.is_number(divisor)) {
      if (!is_zero_literal(text_.word(divisor))) return;
    } else if (!text_.is_identifier(divisor) || constants().zeros.count(text_.word(divisor)) == 0) {
      return;
    }
    const bool is_first = at < 2 || !(text_.is_any(at - 2, ".", "-"));
    const bool by_number = text_.is_number(at - 1) && is_integer(text_.word(at - 1));
    const bool by_name =
        text_.is_identifier(at - 1) && is_first && constants().all.count(text_.word(at - 1)) != 0;
    if ((by_number || by_name) && !text_.is(divisor + 1, ".") && !is_conditional(at))
      text_.error(at, "an integer is divided by zero");
  }

  // It is unknown whether a compiler reports a division in a branch that is not taken, so these are skipped.
  bool is_conditional(std::size_t at) const {
    for (; at > 0 && !text_.is_any(at, ";", "{", "}"); --at)
      if (text_.is_any(at, "?", "if")) return true;
    return false;
  }

  struct Constants {
    std::set<std::string_view> all;    // integers at file scope, static and const, of one literal
    std::set<std::string_view> zeros;  // those that are zero
  };

  const Constants& constants() {
    if (read_) return constants_;
    read_ = true;
    for (const hlsl::Declaration& declaration : text_.declarations()) {
      if (declaration.kind != hlsl::Declaration::Kind::variable) continue;
      for (const Declarator& variable : declarators(text_, declaration.first, declaration.last)) {
        const bool is_int = variable.type == "int" || variable.type == "uint";
        if (!variable.is_static || !variable.is_const || !is_int || variable.dimension_count != 0 ||
            variable.initialiser == npos || variable.initialiser + 1 != variable.end)
          continue;
        const std::string_view value = text_.word(variable.initialiser);
        if (!is_integer(value)) continue;
        constants_.all.insert(text_.word(variable.name));
        if (is_zero_literal(value)) constants_.zeros.insert(text_.word(variable.name));
      }
    }
    return constants_;
  }

  TokenText& text_;
  bool read_ = false;
  Constants constants_;
};

// Finds the members of numbers that are in `asked`.
class MembersOfNumbers final : public ExpressionReader {
 public:
  MembersOfNumbers(const TokenText& text, const std::set<std::size_t>& asked)
      : ExpressionReader(text), asked_(asked) {}

  std::vector<std::size_t> found;

 private:
  void read_binary(const ReadOperand&, std::size_t, const ReadOperand&) override {}
  void read_member(const NumberShape& of, std::size_t member) override {
    if (of.known() && !of.is_matrix() && asked_.contains(member)) found.push_back(member);
  }

  const std::set<std::size_t>& asked_;
};

bool is_of_textures(std::string_view word) {
  return word.size() <= 4 && word.find_first_not_of("stpq") == std::string_view::npos;
}

// Returns the identifiers of these letters after a '.'. `declared` has those that occur elsewhere, and so may
// be members.
std::set<std::size_t> candidates(const TokenText& text, std::set<std::string_view>& declared) {
  std::set<std::size_t> found;
  for (std::size_t at = 1; at < text.size(); ++at) {
    if (!text.is_identifier(at) || !is_of_textures(text.word(at))) continue;
    if (!text.is(at - 1, "."))
      declared.insert(text.word(at));
    else if (!text.is(at + 1, "("))
      found.insert(at);
  }
  return found;
}

// Returns the number of characters per component: 1 for xyzw and rgba, 3 for _11, 4 for _m00; 0 for other
// identifiers.
std::size_t component_length(std::string_view word) {
  if (word.empty()) return 0;
  if (word[0] != '_') {
    const bool letters = word.find_first_not_of("xyzw") == std::string_view::npos ||
                         word.find_first_not_of("rgba") == std::string_view::npos;
    return letters && word.size() <= 4 ? 1 : 0;
  }
  const std::size_t length = word.size() > 1 && word[1] == 'm' ? 4 : 3;
  if (word.size() % length != 0 || word.size() > 4 * length) return 0;
  return word.find_first_not_of("_m01234") == std::string_view::npos ? length : 0;
}

// Returns the first repeated component; empty if there is none.
std::string_view repeated(std::string_view word) {
  const std::size_t length = component_length(word);
  for (std::size_t at = length; length != 0 && at < word.size(); at += length)
    for (std::size_t before = 0; before < at; before += length)
      if (word.substr(before, length) == word.substr(at, length)) return word.substr(at, length);
  return {};
}

// Returns whether `_m00_11` has zero-based and one-based subscripts in one swizzle.
bool counts_in_two_ways(std::string_view word) {
  bool from_one = false;
  bool from_zero = false;
  while (word.size() >= 3 && word[0] == '_') {
    const std::size_t length = word[1] == 'm' ? 4 : 3;
    if (word.size() < length ||
        word.substr(length - 2, 2).find_first_not_of("01234") != std::string_view::npos)
      return false;
    (length == 4 ? from_zero : from_one) = true;
    word.remove_prefix(length);
  }
  return word.empty() && from_one && from_zero;
}

bool is_step(const TokenText& text, std::size_t at) {
  return text.is_any(at, "+", "-") && text.is(at + 1, text.word(at)) &&
         text.word(at).data() + 1 == text.word(at + 1).data();
}

bool is_written(const TokenText& text, std::size_t member) {
  std::size_t behind = member + 1;
  while (text.is(behind, ")")) ++behind;
  if (assignment_length(text, behind) != 0 || is_step(text, member + 1)) return true;
  const std::size_t first = postfix_begin(text, member);
  return first != npos && first > 1 && is_step(text, first - 2) && !text.is(member + 1, ".");
}

using Base = NumberShape::Base;

class OperandKinds final : public ExpressionReader {
 public:
  explicit OperandKinds(TokenText& text) : ExpressionReader(text), text_(text), types_(text.types()) {}

  // glslang ignores a condition of the wrong size, or crashes: it is replaced by `true`.
  void replace_conditions() {
    std::sort(conditions_.begin(), conditions_.end(), [](const ReadOperand& a, const ReadOperand& b) {
      return a.first != b.first ? a.first < b.first : a.end > b.end;
    });
    std::size_t end = 0;
    for (const ReadOperand& condition : conditions_) {
      if (condition.first < end) continue;
      text_.replace(condition.first, condition.end - condition.first, "true");
      end = condition.end;
    }
    text_.apply();
  }

 private:
  void read_sign(std::size_t sign, const ReadOperand& of) override {
    if (text_.is(sign, "~") && of.shape.base == Base::real)
      text_.error(sign,
                  "'~' takes integers, and its operand is a float: convert it with (int), or read its bits "
                  "with asuint()");
  }

  void read_binary(const ReadOperand& left, std::size_t op, const ReadOperand& right) override {
    const std::string_view mark = text_.word(op);
    const bool twice = text_.is(op + 1, mark) && mark.data() + 1 == text_.word(op + 1).data();
    const bool bits = mark == "^" || (mark == "&" || mark == "|") != twice;
    if (bits && std::string_view("&|^").find(mark) != npos) refuse_bits(mark, left, op, right);
    if ((mark == "<" || mark == ">") && twice) refuse_bits(mark == "<" ? "<<" : ">>", left, op, right);
    if (mark == "=" || mark == "!") refuse_comparison(left, op, right);
  }

  void refuse_bits(std::string_view name, const ReadOperand& left, std::size_t op, const ReadOperand& right) {
    if (left.shape.base != Base::real && right.shape.base != Base::real) return;
    text_.error(op,
                "'" + std::string(name) +
                    "' takes integers, and an operand is a float: convert it with (int), or read its bits "
                    "with asuint()");
  }

  void refuse_comparison(const ReadOperand& left, std::size_t op, const ReadOperand& right) {
    for (const ReadOperand& operand : {left, right}) {
      if (operand.end == npos || operand.end == 0 || types_.begin(operand.end - 1) != operand.first) continue;
      const ValueType& type = types_.at(operand.end - 1);
      if (type.name.empty() || (type.dimensions == 0 && types_.find_struct(type.name) == nullptr)) continue;
      const bool array = type.dimensions > 0;
      return text_.error(op,
                         "'" + text_.name(op) + "=' compares numbers, and '" +
                             text_.spelled(operand.first, operand.end - operand.first) + "' is " +
                             (array ? "an array: compare its elements" : "a struct: compare its members"));
    }
  }

  void read_choice(const ReadOperand& condition, std::size_t mark, const ReadOperand& yes,
                   const ReadOperand& no) override {
    const NumberShape& of = condition.shape;
    if (!of.is_vector() || of.columns < 2) return;
    int narrowest = 0;
    for (const ReadOperand& value : {yes, no}) {
      const int columns = value.shape.is_vector() ? value.shape.columns : 0;
      if (columns > 1 && (narrowest == 0 || columns < narrowest)) narrowest = columns;
    }
    if (narrowest == 0 || narrowest >= of.columns) return;
    const std::string size = std::to_string(narrowest);
    text_.error(mark, "the condition before this '?' has " + std::to_string(of.columns) +
                          " components, and its values have " + size + " (X3019): give the condition " +
                          size + " as well, as in (p." +
                          std::string("xyzw").substr(0, static_cast<std::size_t>(narrowest)) + " > 0)");
    conditions_.push_back(condition);
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<ReadOperand> conditions_;
};

}  // namespace

void check_constant_divisions(TokenText& text) {
  ConstantDivisions(text).run();
}

void check_letter_swizzles(TokenText& text) {
  std::set<std::string_view> declared;
  const std::set<std::size_t> asked = candidates(text, declared);
  if (asked.empty()) return;
  std::set<std::size_t> refused;
  for (const std::size_t at : asked)
    if (!declared.contains(text.word(at))) refused.insert(at);
  if (refused.size() < asked.size()) {
    MembersOfNumbers numbers(text, asked);
    numbers.read_all();
    refused.insert(numbers.found.begin(), numbers.found.end());
  }
  for (const std::size_t at : refused) {
    const std::string word = text.name(at);
    std::string meant;
    for (const char c : word) meant += "xyzw"[std::string_view("stpq").find(c)];
    text.error(at,
               "'." + word + "' is not a swizzle of HLSL, which has xyzw and rgba: write '." + meant + "'");
  }
}

void check_repeated_components(TokenText& text) {
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (!text.is_identifier(at) || !text.is(at - 1, ".")) continue;
    if (counts_in_two_ways(text.word(at)) && text.types().named(at) == npos)
      text.error(at, "'." + text.name(at) +
                         "' mixes zero-based and one-based subscripts: write _m00 or _11 throughout");
    const std::string_view component = repeated(text.word(at));
    if (component.empty() || text.types().named(at) != npos || !is_written(text, at)) continue;
    text.error(at, "'." + text.name(at) + "' has " + std::string(component) +
                       " twice, and cannot be written: name each component once");
  }
}

void check_operand_kinds(TokenText& text) {
  OperandKinds kinds(text);
  kinds.read_all();
  kinds.replace_conditions();
}

}  // namespace penumbra::preparation
