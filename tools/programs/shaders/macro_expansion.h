// Includes and macros: from a file to the text without them. Internal to this room.
//
// Where the request asks for preparation, macros that name themselves are expanded as in C
// (preparation/macro_own_names.h), and two things that glslang's preprocessor refuses and Unity's takes
// are let through, neither of which moves a line:
// - A macro defined twice, as two different things: the later definition counts, from where it stands, and a
//   warning says so.
// - Macro arguments that expand to several (preparation/macro_arguments.h): the text is read again with such
//   calls said in two steps, as often as that brings new ones to light.
#pragma once

#include "shaders/compile.h"

namespace penumbra::shaders {

struct Source;

// An empty text of a source that is not empty is a failure, told in `out.diagnostics`.
void expand_macros(const Source& source, SourceMemory& memory, PreprocessedSource& out);

}  // namespace penumbra::shaders
