// Arguments with more components than the parameter: HLSL takes the first ones, with a warning (X3206);
// glslang finds "no matching overloaded function". Such an argument is cast to the parameter's type, which
// takes the same components.
//
// Only of functions that are not overloaded with as many parameters, and of arguments whose type is known
// (value_types.h), that read a texture, or that are a mul().
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void narrow_arguments(TokenText& text);

}  // namespace penumbra::preparation
