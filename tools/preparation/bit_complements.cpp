#include <algorithm>

#include "preparation/expression_reader.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

class FloatComplements final : public ExpressionReader {
 public:
  explicit FloatComplements(const TokenText& text) : ExpressionReader(text), text_(text) {}

  std::vector<std::size_t> found;  // the '~' before each

 private:
  void read_binary(const ReadOperand&, std::size_t, const ReadOperand&) override {}
  void read_sign(std::size_t sign, const ReadOperand& of) override {
    if (text_.is(sign, "~") && of.shape.base == NumberShape::Base::real) found.push_back(sign);
  }

  const TokenText& text_;
};

}  // namespace

void check_bit_complements(TokenText& text) {
  const auto& tokens = text.tokens();
  if (std::none_of(tokens.begin(), tokens.end(),
                   [](const hlsl::Token& token) { return token.spelling == "~"; }))
    return;
  FloatComplements complements(text);
  complements.read_all();
  for (const std::size_t at : complements.found)
    text.note(at, hlsl::Severity::error,
              "'~' takes integers, and its operand is a float: convert it with (int), or read its bits with "
              "asuint()");
}

}  // namespace penumbra::preparation
