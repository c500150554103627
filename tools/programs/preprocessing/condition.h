// The value of #if and #elif as glslang evaluates it: in int, without short-circuit evaluation. Internal to
// this folder.
#pragma once

#include "preprocessing/expansion.h"

namespace penumbra::preprocessing {

bool holds(const Token* first, const Token* last, Expansion& expansion, const Macros& macros,
           const Spellings& spellings);

}  // namespace penumbra::preprocessing
