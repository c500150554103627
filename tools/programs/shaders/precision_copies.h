// SPIRV-Cross copies a value of another precision before it reads it, `mediump int mp_copy_7 = _7;`. A
// loop-carried value is copied at the head of the loop, inside its braces, and the copy is also read after
// the loop, where it is out of scope (SPIRV-Cross as of Debian 12). Such a text is detected here; no copies
// are made for a module without relaxed precision.
#pragma once

#include <string_view>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Returns whether the text reads a precision copy whose declaration is out of scope.
bool reads_lost_copy(std::string_view essl);

// Returns the module with everything in full precision, which relaxed precision allows (SPIR-V specification,
// 3.20: RelaxedPrecision).
SpirvModule without_relaxed_precision(const SpirvModule& module);

}  // namespace penumbra::shaders
