// Calls of a struct's member functions on what is not a variable of the function that calls: on what a
// function returned (`Build(x).Sample(uv)`), on a const variable, a static global, a member of a cbuffer, an
// element of a structured buffer. glslang passes the receiver by a pointer that such values do not have and
// makes a module that is not valid.
//
// Beside the struct a function is put that takes the receiver as its first parameter and calls the member on
// it: by value where the receiver cannot be written to, inout where it can, which is what a call of the
// member does to it. The calls go there.
//
// Limits: the receiver's type must be known (value_types.h); member functions with parameters that have no
// name are left alone.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void call_members_on_variables(TokenText& text);

}  // namespace penumbra::preparation
