// A `for` loop's variable that is read after the loop: in Unity's compiler it belongs to the block that
// contains the loop (warning X3078), in glslang its scope is the loop. `for (int i = 0; i < n; ++i) { }
// use(i);` becomes `int i_of_loop = 0; for (; i_of_loop < n; ++i_of_loop) { } use(i_of_loop);`.
//
// If the block has another variable of that name, uses after the loop refer to the loop's variable, as that
// warning says; a warning reports it. A loop that is the body of an if or of a loop, without braces, is not
// changed.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void keep_loop_variables(TokenText& text);

}  // namespace penumbra::preparation
