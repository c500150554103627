// Structs with member functions inside a namespace: glslang declares the functions under one name and looks
// them up under another ("no matching overloaded function found"). Where a text has one, all its namespaces
// are written out: A::B::f becomes A_B_f, wherever it is declared, named in full, or named from inside its
// namespaces. Members of structs keep their names.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_namespaces(TokenText& text);

}  // namespace penumbra::preparation
