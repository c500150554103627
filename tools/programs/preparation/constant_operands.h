// Operands that are constants, where glslang works the result out while it parses and gets it wrong:
//
// - fmod() and % of floats: fmod(-7, 2) is 1 and -7.5 % 2 is -7.5, where HLSL has -1 and -1.5;
// - < > <= >= of vectors: the first components alone are compared;
// - any(), all() and dot() of numbers other than bools and floats;
// - comparisons and functions of matrices: memory outside of them is read.
//
// One operand goes through a function that returns it, which glslang does not work out. SPIRV-Tools does,
// later and right. Linear time.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void hide_constant_operands(TokenText& text);

}  // namespace penumbra::preparation
