// SPIRV-Cross copies a value into one of another precision before it reads it, `mediump int mp_copy_7 = _7;`.
// A value that changes with a loop is copied at the head of the loop, between its braces, and the copy read
// after them too, where its name stands for nothing (SPIRV-Cross as of Debian 12). Such a text is found here,
// and of a module without relaxed precision no copies are made.
#pragma once

#include <string_view>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Whether the text reads a copy of another precision where no declaration of it is in scope.
bool reads_lost_copy(std::string_view essl);

// Everything in full precision, which relaxed precision allows (SPIR-V specification, 3.20:
// RelaxedPrecision).
SpirvModule without_relaxed_precision(const SpirvModule& module);

}  // namespace penumbra::shaders
