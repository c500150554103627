// Texture and sampler types with a precision suffix, Texture2D_half, sampler2D_float and similar (Unity's,
// docs.unity3d.com/Manual/SL-DataTypesAndPrecision.html), become the plain type. half is float here, so only
// the name changes.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void drop_texture_precision(TokenText& text);

}  // namespace penumbra::preparation
