// A function that has a type and no return statement: what is left of one whose returns all stand under
// keywords that are off. Unity's compilers take it as long as nothing calls it; glslang refuses it ("must
// return a value"). It returns zero instead, with a note; where there is no zero, for textures and samplers,
// a function whose name stands nowhere else is left out. A function that returns on some paths alone is left
// to the compilers.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void return_from_empty_functions(TokenText& text);

}  // namespace penumbra::preparation
