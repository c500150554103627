// What vkd3d adds to bytecode: instructions of its module that are no operation of the program, and that a
// count of operations (counted_module.h) leaves out.
//
// Bytecode has truth as 0 or all bits, and addresses of buffers and groupshared memory as an element and an
// offset. For SPIR-V vkd3d makes masks of comparisons and conditions of masks, multiplies and adds addresses,
// and keeps the number of a shift below 32. What an instruction of the bytecode gives, it stores to a
// register.
#pragma once

#include <cstdint>
#include <set>

#include "spirv/module.h"

namespace penumbra::shaders {

// Their results. For BytecodeModule::untouched.
std::set<std::uint32_t> translation_steps(const spirv::Module& untouched);

}  // namespace penumbra::shaders
