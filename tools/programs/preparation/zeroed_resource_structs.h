// `(S)0` where the struct S holds textures, samplers or buffers. Unity's compilers zero the numbers and leave
// the resources unset until they are assigned; glslang refuses ("cannot implicitly initialize opaque
// members").
//
// After the struct a function is put that returns an S whose other members are 0, and the cast becomes a call
// of it. A resource that is read without having been assigned is an error of the module (lost_resources.h).
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void zero_resource_structs(TokenText& text);

}  // namespace penumbra::preparation
