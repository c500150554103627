#include "preparation/list_elements.h"

namespace penumbra::preparation {

std::vector<ListElement> list_elements(const TokenText& text, std::size_t open) {
  std::vector<ListElement> elements;
  const std::size_t close = text.matching_bracket(open);
  std::size_t first = open + 1;
  for (std::size_t at = first; at <= close; ++at) {
    if (at == close || text.is(at, ",")) {
      if (at > first) elements.push_back({first, at});
      first = at + 1;
    } else if (text.matching_bracket(at) != npos && text.matching_bracket(at) > at) {
      at = text.matching_bracket(at);
    }
  }
  return elements;
}

}  // namespace penumbra::preparation
