// The variable of a `for` that is read after the loop: to Unity's compiler it belongs to the block that the
// loop stands in (warning X3078), to glslang it ends with the loop. `for (int i = 0; i < n; ++i) { } use(i);`
// becomes `int i_of_loop = 0; for (; i_of_loop < n; ++i_of_loop) { } use(i_of_loop);`.
//
// Where the block has another variable of that name, what stands after the loop means the loop's, as that
// warning says; a note tells so. A loop that is itself the body of an if or a loop, without braces, stays.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void outlive_loops(TokenText& text);

}  // namespace penumbra::preparation
