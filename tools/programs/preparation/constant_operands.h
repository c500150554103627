// Constant operands, for which glslang's constant folding is wrong:
//
// - fmod() and % of floats: fmod(-7, 2) is 1 and -7.5 % 2 is -7.5, where HLSL has -1 and -1.5;
// - < > <= >= of vectors: only the first components are compared;
// - any(), all() and dot() of numbers other than bools and floats;
// - comparisons and functions of matrices: out-of-bounds memory is read.
//
// One operand is passed through a function that returns it, which prevents folding in glslang; SPIRV-Tools
// folds the operation later, correctly. Linear time.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void hide_constant_operands(TokenText& text);

}  // namespace penumbra::preparation
