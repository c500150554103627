// Calls of a struct's member functions on objects other than the caller's own variables: on the result of a
// function (`Build(x).Sample(uv)`), a const variable, a static global, a member of a cbuffer, an element of a
// structured buffer. glslang passes the object by a pointer that such values do not have, and emits an
// invalid module.
//
// After the struct, a function is added that takes the object as its first parameter and calls the member
// function: by value if the object is read-only, otherwise as inout, which preserves the member function's
// side effects. The calls are redirected to it.
//
// Limits: the object's type must be known (value_types.h); member functions with unnamed parameters are not
// changed.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void call_members_on_variables(TokenText& text);

}  // namespace penumbra::preparation
