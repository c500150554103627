// `(const int)x`: glslang takes no const in a cast, where it means nothing.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void drop_const_of_casts(TokenText& text);

}  // namespace penumbra::preparation
