// Initialiser lists of structs and of arrays of structs. HLSL fills the numbers of a value in their order,
// whatever the braces: `struct Ray { float3 origin; float t; }; Ray r = { 0, 0, 0, 1 };`. glslang wants one
// element of the list for each member. Where the list is of another form, it is written with one element for
// each member: `{ float3(0, 0, 0), 1 }`.
//
// An element that is split among members must be a vector that may be written several times: no call, ++ or
// -- in it. How many numbers an element has must be known: of literals, constructors, and what value_types.h
// knows; of one element of another kind it follows from the others.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void match_struct_initialisers(TokenText& text);

}  // namespace penumbra::preparation
