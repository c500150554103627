// The kind of value that a function returns, in a module that has its functions and names.
#pragma once

#include <string>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Returns whether a function of that name, with any parameters, returns more than one number.
bool returns_several_numbers(const SpirvModule& module, const std::string& function);

}  // namespace penumbra::shaders
