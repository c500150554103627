// Structured and byte address buffers in a local variable or a member of a struct. In HLSL these are aliases
// of a buffer that must be known at compile time; glslang cannot assign buffers at all ("could not create
// assignment", "buffer aliasing not yet supported"), but passes them to functions correctly.
//
// Everything that is assigned to such a variable or member is traced, through parameters and other such
// variables, to the global buffers it comes from. If there is only one, its name replaces every use of the
// variable or member, and declarations and assignments are removed. If a member is read before the buffer's
// declaration, the declaration moves before the function that reads it.
//
// Limits: in the whole text, a member is an alias of one buffer; if two structs of a type contain different
// buffers, an error names them and suggests passing the buffer as an argument. Array elements, initialiser
// lists and buffers that a function returns are not traced.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void resolve_buffer_aliases(TokenText& text);

}  // namespace penumbra::preparation
