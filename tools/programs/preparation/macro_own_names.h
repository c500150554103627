// Macros that name themselves: `#define _Color ACCESS(Props, _Color)`.
//
// A name in the expansion of its own macro is not expanded again (C standard 6.10.3.4). glslang forgets that
// once the expansion has passed through the argument of another macro, and expands it again for each one,
// without a word. So the name is marked where it stands in its macro's body: what is marked is no macro's
// name. The marks go from what the preprocessor leaves.
//
// Left alone beside ##, where the name becomes another one. No line moves.
#pragma once

#include <string>

namespace penumbra::preparation {

std::string with_own_names_marked(std::string text);  // of a source, before the preprocessor
std::string without_marks(std::string text);          // of what the preprocessor made of it

}  // namespace penumbra::preparation
