// Expands includes and macros. Internal to this folder.
//
// If the request asks for preparation, macros that refer to themselves are expanded as in C
// (preparation/macro_arguments.h), and two constructs that glslang's preprocessor rejects and Unity's accepts
// are handled, without moving a line:
// - A macro with two different definitions: each holds from its line on, with a warning.
// - Macro arguments that expand to several (preparation/macro_arguments.h): the text is read again with such
//   calls rewritten to two steps, until no new ones appear.
#pragma once

#include "shaders/compile.h"

namespace penumbra::shaders {

struct Source;

// An empty result for a non-empty source is a failure, reported in `out.diagnostics`.
void expand_macros(const Source& source, SourceMemory& memory, PreprocessedSource& out);

}  // namespace penumbra::shaders
