// Unqualified calls of a struct's functions from its other functions: glslang does not convert their
// arguments (`f(1)` with a float parameter: "no matching overloaded function found"). They become
// `this.f(1)`.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void call_own_methods_by_this(TokenText& text);

}  // namespace penumbra::preparation
