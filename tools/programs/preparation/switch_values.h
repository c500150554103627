// In `switch (h)` with a half or float, HLSL truncates the value, while glslang accepts only integers. The
// value is cast to int if its type is known.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void cast_switch_values(TokenText& text);

}  // namespace penumbra::preparation
