// Writes to uniforms: HLSL lets a shader assign to a global variable or a member of a cbuffer, which changes
// only this invocation's copy (docs "Variable Syntax": extern globals are initialised from outside). glslang
// rejects an assignment ("can't modify a uniform") and silently drops writes through out and inout
// parameters.
//
// Every numeric uniform or uniform struct of numbers that is assigned to, in whole or in part, incremented or
// decremented, or passed to an out parameter of a function of the text gets a static variable, initialised
// from it at the beginning of the shader, which replaces every use in a function.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void copy_written_uniforms(TokenText& text);

}  // namespace penumbra::preparation
