// A ';' that ends nothing: at file scope, where a macro that expands to nothing leaves one behind, and after
// another ';' among the members of a struct or cbuffer. Unity's compilers read past it; glslang's grammar has
// no such declaration ("Expected declaration"). It is taken out.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void drop_stray_semicolons(TokenText& text);

}  // namespace penumbra::preparation
