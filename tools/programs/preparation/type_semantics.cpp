#include "preparation/type_semantics.h"

#include <string>

#include "preparation/declarators.h"

namespace penumbra::preparation {

void rename_type_semantics(TokenText& text) {
  for (std::size_t at = 2; at + 1 < text.size(); ++at) {
    if (!text.is(at - 1, ":") || !text.is_identifier(at) || !is_number_type(text[at].spelling)) continue;
    const bool ends =
        text.is(at + 1, ";") || text.is(at + 1, ",") || text.is(at + 1, ")") || text.is(at + 1, "{");
    if (ends) text.replace(at, 1, "TYPE_" + std::string(text[at].spelling) + "_");
  }
  text.apply();
}

}  // namespace penumbra::preparation
