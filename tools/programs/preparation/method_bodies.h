// Member functions that are declared in a struct and defined later: `struct S { float f(); };` and `float
// S::f() { return a; }`, or the body further down in the struct. glslang accepts definitions only within the
// struct. The definition replaces the prototype, with its original lines.
//
// Numeric variables that a body uses and that are declared after the struct are moved before it. Limits:
// functions and other types that are declared between the struct and the definition are then unknown in the
// body.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void put_bodies_into_structs(TokenText& text);

}  // namespace penumbra::preparation
