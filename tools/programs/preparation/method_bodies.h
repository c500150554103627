// Member functions that a struct declares and that are defined later: `struct S { float f(); };` and
// `float S::f() { return a; }`, or the body further down in the struct. glslang takes definitions in the
// struct alone. The definition takes the prototype's place, with the lines it has.
//
// Variables of numeric types that a body names and that are declared behind the struct are put before it.
// Limits: functions and other types between the struct and the definition are not known to the body then.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void put_bodies_into_structs(TokenText& text);

}  // namespace penumbra::preparation
