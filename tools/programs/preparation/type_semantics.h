// Semantics that are called like a type, `float3x3 basis : float3x3;`: any word is one to Unity's compiler,
// and to glslang "expected a semantic". They get a name that is no type; stages that share the struct share
// it.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void rename_type_semantics(TokenText& text);

}  // namespace penumbra::preparation
