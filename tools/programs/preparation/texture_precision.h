// Texture and sampler types that carry the precision of what is read: Texture2D_half, sampler2D_float and the
// like (Unity's, docs.unity3d.com/Manual/SL-DataTypesAndPrecision.html) become the plain type. Precision of
// half is float here, so nothing changes but the name.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void drop_texture_precision(TokenText& text);

}  // namespace penumbra::preparation
