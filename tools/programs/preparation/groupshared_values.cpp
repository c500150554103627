#include <string>

#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

void check_groupshared_values(TokenText& text) {
  for (const DeclaredValue& value : text.types().declared()) {
    const bool inside =
        value.place == DeclaredValue::Place::local || value.place == DeclaredValue::Place::member;
    if (!inside || value.first == npos || value.name == npos) continue;
    for (std::size_t at = value.first; at < value.name; ++at)
      if (text.is(at, "groupshared"))
        text.note(at, hlsl::Severity::error,
                  "'" + std::string(text[value.name].spelling) +
                      "' is groupshared, and such variables belong outside of functions and structs");
  }
}

}  // namespace penumbra::preparation
