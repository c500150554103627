// Struct inheritance, `struct B : A { ... };`. glslang parses the base and ignores it: a member of A is an
// unknown variable in B. The members and functions of A are copied to the beginning of B, where HLSL also
// places them, and the base is removed. A function declared in B hides A's function of that name.
//
// Where an A is expected, a B is converted by a call of a function that copies the members of A: in a cast,
// `(A)b`, in a function's argument, and in an initialiser or an assignment, `A a = b;`. The type of the
// converted expression must be known (value_types.h).
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_base_members(TokenText& text);

}  // namespace penumbra::preparation
