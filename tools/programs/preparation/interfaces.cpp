#include <string>

#include "preparation/source_checks.h"

namespace penumbra::preparation {

void check_interfaces(TokenText& text) {
  for (std::size_t at = 0; at + 2 < text.size(); ++at)
    if (text.is(at, "interface") && text.is_identifier(at + 1) && text.is(at + 2, "{"))
      text.note(at, hlsl::Severity::error,
                "not supported here: interfaces, such as '" + std::string(text[at + 1].spelling) +
                    "'; take it out, name the struct itself where a parameter or variable has its type, and "
                    "choose between structs with #if");
}

}  // namespace penumbra::preparation
