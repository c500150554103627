// Empty declarations: a ';' at file scope, often left by a macro that expands to nothing, and after another
// ';' among the members of a struct or cbuffer. Unity's compilers accept them; glslang's grammar does not
// ("Expected declaration"). They are removed.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void drop_stray_semicolons(TokenText& text);

}  // namespace penumbra::preparation
