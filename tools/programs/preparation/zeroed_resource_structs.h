// The cast `(S)0` for a struct S with textures, samplers or buffers. Unity's compilers zero the numbers and
// leave the resources unset until they are assigned; glslang reports "cannot implicitly initialize opaque
// members".
//
// After the struct, a function is added that returns an S whose other members are 0, and the cast becomes a
// call of it. A resource that is read before it is assigned is an error (shaders/lost_resources.h).
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void zero_resource_structs(TokenText& text);

}  // namespace penumbra::preparation
