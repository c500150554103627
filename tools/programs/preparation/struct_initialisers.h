// Initialiser lists of structs and of arrays of structs. HLSL fills the scalars of a value in order, whatever
// the braces: `struct Ray { float3 origin; float t; }; Ray r = { 0, 0, 0, 1 };`. glslang expects one list
// element per member. A list of another form is rewritten with one element per member: `{ float3(0, 0, 0), 1
// }`.
//
// An element that is split among members must be a vector without side effects: no call, ++ or -- in it. The
// number of scalars of every element must be known: for literals, constructors, and values that value_types.h
// knows; for one element of another kind it follows from the others.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void match_struct_initialisers(TokenText& text);

}  // namespace penumbra::preparation
