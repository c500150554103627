#include "preparation/list_elements.h"

namespace penumbra::preparation {

std::vector<ListElement> list_elements(const TokenText& text, std::size_t open) {
  std::vector<ListElement> elements;
  const std::size_t close = text.partner(open);
  std::size_t first = open + 1;
  for (std::size_t at = first; at <= close; ++at) {
    if (at == close || text.is(at, ",")) {
      if (at > first) elements.push_back({first, at});
      first = at + 1;
    } else if (text.partner(at) != npos && text.partner(at) > at) {
      at = text.partner(at);
    }
  }
  return elements;
}

}  // namespace penumbra::preparation
