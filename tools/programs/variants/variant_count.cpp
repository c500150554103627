#include "variants/variant_count.h"

namespace penumbra::variants {

std::string text_of(VariantCount count) {
  const std::string digits = std::to_string(count.saturated() ? count.value() - 1 : count.value());
  std::string text = count.saturated() ? "more than " : "";
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i != 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

}  // namespace penumbra::variants
