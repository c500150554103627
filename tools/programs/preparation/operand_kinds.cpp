#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "preparation/expression_reader.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

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
      text_.note(sign, hlsl::Severity::error,
                 "'~' takes integers, and its operand is a float: convert it with (int), or read its bits "
                 "with asuint()");
  }

  void read_binary(const ReadOperand& left, std::size_t op, const ReadOperand& right) override {
    const std::string_view mark = text_[op].spelling;
    const bool twice = text_.is(op + 1, mark) && mark.data() + 1 == text_[op + 1].spelling.data();
    const bool bits = mark == "^" || (mark == "&" || mark == "|") != twice;
    if (bits && std::string_view("&|^").find(mark) != npos) refuse_bits(mark, left, op, right);
    if ((mark == "<" || mark == ">") && twice) refuse_bits(mark == "<" ? "<<" : ">>", left, op, right);
    if (mark == "=" || mark == "!") refuse_comparison(left, op, right);
  }

  void refuse_bits(std::string_view name, const ReadOperand& left, std::size_t op, const ReadOperand& right) {
    if (left.shape.base != Base::real && right.shape.base != Base::real) return;
    text_.note(op, hlsl::Severity::error,
               "'" + std::string(name) +
                   "' takes integers, and an operand is a float: convert it with (int), or read its bits "
                   "with asuint()");
  }

  void refuse_comparison(const ReadOperand& left, std::size_t op, const ReadOperand& right) {
    for (const ReadOperand& operand : {left, right}) {
      if (operand.end == npos || operand.end == 0 || types_.begin(operand.end - 1) != operand.first) continue;
      const ValueType& type = types_.at(operand.end - 1);
      if (type.name.empty() || (type.dimensions == 0 && !types_.structs().contains(type.name))) continue;
      const bool array = type.dimensions > 0;
      return text_.note(op, hlsl::Severity::error,
                        "'" + std::string(text_[op].spelling) + "=' compares numbers, and '" +
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
    text_.note(mark, hlsl::Severity::error,
               "the condition before this '?' has " + std::to_string(of.columns) +
                   " components, and its values have " + size + " (X3019): give the condition " + size +
                   " as well, as in (p." +
                   std::string("xyzw").substr(0, static_cast<std::size_t>(narrowest)) + " > 0)");
    conditions_.push_back(condition);
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<ReadOperand> conditions_;
};

}  // namespace

void check_operand_kinds(TokenText& text) {
  OperandKinds kinds(text);
  kinds.read_all();
  kinds.replace_conditions();
}

}  // namespace penumbra::preparation
