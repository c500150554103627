// Arguments with more components than the parameter: HLSL truncates them, with a warning (X3206); glslang
// reports "no matching overloaded function". Such an argument is cast to the parameter's type, which keeps
// the same components.
//
// Only for functions without an overload of as many parameters, and for arguments whose type is known
// (value_types.h), texture reads, and mul().
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void narrow_arguments(TokenText& text);

}  // namespace penumbra::preparation
