// Semantics with the name of a type, `float3x3 basis : float3x3;`: Unity's compiler accepts any identifier,
// glslang reports "expected a semantic". They are renamed, identically in all stages that share the struct.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void rename_type_semantics(TokenText& text);

}  // namespace penumbra::preparation
