// Structs that inherit, `struct B : A { ... };`. glslang reads the base and forgets it: a member of A is an
// unknown variable in B. The members and functions of A are written out at the beginning of B, where they lie
// in HLSL as well, and the base goes. A function that B has itself hides A's of that name.
//
// A B where an A is wanted becomes a call of a function that copies the members of A: in a cast, `(A)b`, as
// the argument of a function, and in an initialiser or an assignment, `A a = b;`. The type of what is
// converted must be known (value_types.h).
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_base_members(TokenText& text);

}  // namespace penumbra::preparation
