#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

void check_string_values(TokenText& text) {
  const ValueTypes& types = text.types();
  if (types.structs().contains("string")) return;
  for (const DeclaredValue& value : types.declared()) {
    if (value.name == npos || !value.type.is("string")) continue;
    const bool global = value.place == DeclaredValue::Place::global;
    text.note(value.name, global ? hlsl::Severity::warning : hlsl::Severity::error,
              global ? "shaders do not read strings: this variable has no effect"
                     : "HLSL has strings at file scope alone, and shaders do not read them: remove it");
  }
}

}  // namespace penumbra::preparation
