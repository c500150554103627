#include "preparation/storage_order.h"

#include "preparation/declared_values.h"

namespace penumbra::preparation {

void put_static_first(TokenText& text) {
  for (std::size_t at = 1; at < text.size(); ++at) {
    if (!text.is(at, "static")) continue;
    for (std::size_t before = at;
         before-- > 0 && text.is_identifier(before) && is_modifier(text[before].spelling);) {
      if (!text.is(before, "const")) continue;
      text.erase(before, 1);
      text.replace(at, 1, "static const");
      break;
    }
  }
  text.apply();
}

}  // namespace penumbra::preparation
