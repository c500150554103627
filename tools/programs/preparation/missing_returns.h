// A function with a return type and no return statement, because all of its returns are in branches of
// disabled keywords. Unity's compilers accept it if nothing calls it; glslang reports "must return a value".
// It returns zero instead, with a note; a function of texture or sampler type, for which there is no zero, is
// removed if its name is not used elsewhere. A function that returns on some paths is left to the compilers.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void return_from_empty_functions(TokenText& text);

}  // namespace penumbra::preparation
