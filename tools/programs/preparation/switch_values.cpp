#include "preparation/switch_values.h"

#include "preparation/expression_reader.h"

namespace penumbra::preparation {

namespace {

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

}  // namespace

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

}  // namespace penumbra::preparation
