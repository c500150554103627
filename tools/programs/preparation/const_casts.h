// `(const int)x`: glslang does not accept const in a cast, where it has no effect.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void drop_const_of_casts(TokenText& text);

}  // namespace penumbra::preparation
