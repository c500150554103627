// Macros that refer to themselves: `#define _Color ACCESS(Props, _Color)`.
//
// A name in the expansion of its own macro is not expanded again (C standard 6.10.3.4). glslang forgets this
// once the expansion has passed through the argument of another macro, and silently expands it again for each
// one. So the name is marked in its macro's body; a marked name is not a macro's name. The marks are removed
// from the preprocessor's output.
//
// A name beside ## is not marked, because it becomes part of another one. Line numbers do not change.
#pragma once

#include <string>

namespace penumbra::preparation {

std::string with_own_names_marked(std::string text);  // called for a source, before preprocessing
std::string without_marks(std::string text);          // called for the preprocessor's output

}  // namespace penumbra::preparation
