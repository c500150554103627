#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

void check_string_values(TokenText& text, const EntryPoint& entry) {
  const ValueTypes& types = text.types();
  if (types.structs().contains("string")) return;
  for (const DeclaredValue& value : types.declared()) {
    if (value.name == npos || value.type.name != "string") continue;
    const bool refused = entry.dxc && value.place != DeclaredValue::Place::global;
    text.note(value.name, refused ? hlsl::Severity::error : hlsl::Severity::warning,
              refused ? "strings may only be declared at file scope, and shaders do not read them: remove it"
                      : "shaders do not read strings: this variable has no effect");
  }
}

}  // namespace penumbra::preparation
