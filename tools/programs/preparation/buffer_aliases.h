// Structured and byte address buffers held in a local variable or a member of a struct. In HLSL these are
// names for a buffer that the compiler must be able to tell; glslang cannot assign buffers at all ("could not
// create assignment", "buffer aliasing not yet supported"), while it passes them to functions as it should.
//
// Everything that is ever assigned to such a variable or member is followed, through parameters and other
// such variables, to the global buffers it comes from. Where that is one and the same everywhere, its name is
// put wherever the variable or member was read, and declarations and assignments go: there is nothing else
// that a read after an assignment can mean. A member may be read before the buffer is declared; the buffer's
// declaration then goes before the function that reads.
//
// Limits: one member stands for one buffer in the whole text; where two structs of a type hold different
// buffers, an error says which, and the way out is to pass the buffer as an argument. Elements of arrays,
// initialisers in braces and buffers that a function returns are not followed.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void resolve_buffer_aliases(TokenText& text);

}  // namespace penumbra::preparation
