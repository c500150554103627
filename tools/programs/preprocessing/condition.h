// Evaluates the condition of an #if. Internal to this folder.
#pragma once

#include "preprocessing/expansion.h"

namespace penumbra::preprocessing {

// Throws Problem.
bool holds(const Token* first, const Token* last, Expansion& expansion, const Spellings& spellings);

}  // namespace penumbra::preprocessing
