#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

void check_static_members(TokenText& text) {
  const ValueTypes& types = text.types();
  for (const auto& [name, type] : types.structs())
    for (const std::size_t member : type.members) {
      const DeclaredValue& value = types.declared()[member];
      if (value.is_static && value.name != npos)
        text.note(value.name, hlsl::Severity::error,
                  "'" + std::string(text[value.name].spelling) +
                      "' is a static member, which is not supported: declare it outside of the structure");
    }
}

}  // namespace penumbra::preparation
