#include "preparation/unsigned_types.h"

#include <string>
#include <string_view>

#include "preparation/declarators.h"

namespace penumbra::preparation {

void name_unsigned_types(TokenText& text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!text.is(at, "unsigned")) continue;
    const std::string_view next = text.is_identifier(at + 1) ? text[at + 1].spelling : std::string_view();
    if (!is_number_type(next)) {
      text.replace(at, 1, "uint");
    } else if (next.starts_with("int")) {
      text.replace(at, 2, "u" + std::string(next));
    } else if (next.starts_with("uint") || next.starts_with("dword")) {
      text.erase(at, 1);
    } else if (next.starts_with("min16int")) {
      text.replace(at, 2, "min16u" + std::string(next.substr(5)));
    }
  }
  text.apply();
}

}  // namespace penumbra::preparation
