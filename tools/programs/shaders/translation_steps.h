// The instructions that vkd3d adds to bytecode: they are no operations of the program, and a count of
// operations (counted_module.h) leaves them out.
//
// Bytecode has truth as 0 or all bits, and addresses of buffers and groupshared memory as an element and an
// offset. For SPIR-V, vkd3d turns comparisons into masks and masks into conditions, multiplies and adds
// addresses, and keeps the number of a shift below 32. It stores the result of each instruction of the
// bytecode to a register.
#pragma once

#include <cstdint>
#include <set>

#include "spirv/module.h"

namespace penumbra::shaders {

// Returns the results of these instructions. `untouched` is BytecodeModule::untouched.
std::set<std::uint32_t> translation_steps(const spirv::Module& untouched);

}  // namespace penumbra::shaders
