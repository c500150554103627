// Variables and structs with member functions inside a namespace: glslang declares them under one name and
// looks them up under another ("no matching overloaded function found"). If a text has one, all its
// namespaces are replaced by prefixes: A::B::f becomes A_B_f, in its declaration, in qualified names, and in
// unqualified uses within the namespace. Members of structs keep their names.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_namespaces(TokenText& text);

}  // namespace penumbra::preparation
