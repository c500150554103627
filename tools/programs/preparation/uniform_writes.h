// Writes to uniforms: HLSL lets a shader assign to a global variable or a member of a cbuffer, which changes
// the copy of this invocation alone (docs "Variable Syntax": extern globals are initialised from outside).
// glslang refuses an assignment ("can't modify a uniform") and drops, without a word, what a function writes
// through an out or inout parameter.
//
// Every uniform of a number type or a struct that is assigned to, in whole or in part, stepped by ++ or --,
// or passed for an out parameter of a function of the text gets a static variable of its own, initialised
// from it when the shader starts, and every use in a function reads and writes that variable.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void copy_written_uniforms(TokenText& text);

}  // namespace penumbra::preparation
