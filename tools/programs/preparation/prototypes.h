// Prototypes that glslang misreads. It treats a parameter's `const` as part of how it is passed: if prototype
// and definition differ in it, a call emits invalid SPIR-V or crashes. And it treats a prototype of the entry
// point as a different function, without a body.
//
// A prototype is removed if nothing between it and the definition calls the function; in the others, each
// parameter is const where it is in the definition.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void match_prototypes(TokenText& text);

}  // namespace penumbra::preparation
