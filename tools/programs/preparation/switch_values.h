// `switch (h)` of a half or float: HLSL takes its whole part, and glslang only integers. The value is cast to
// int where its type is known.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void cast_switch_values(TokenText& text);

}  // namespace penumbra::preparation
