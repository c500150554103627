// Prototypes. glslang takes a parameter's `const` for a part of how it is passed: where prototype and
// definition differ in it, a call writes SPIR-V that is not valid, or ends the process. And it takes a
// prototype of the entry point for another function without a body.
//
// A prototype that nothing between it and the definition calls goes; in one that stays each parameter is
// const where the definition has it so.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void match_prototypes(TokenText& text);

}  // namespace penumbra::preparation
