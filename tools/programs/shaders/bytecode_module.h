// SPIR-V made from FXC's bytecode, by vkd3d-shader: the output of Unity's compiler in a form that a Vulkan
// device runs.
//
// The module has the names, the entry point and the kinds of resources that compile() gives the same HLSL, so
// that a host binds both alike. But vkd3d has only registers of a constant buffer, so its members come beside
// the module.
#pragma once

#include <set>

#include "shaders/reflect.h"
#include "shaders/spirv_module.h"
#include "shaders/stage_signature.h"
#include "spirv/module.h"

namespace penumbra::shaders {

struct BytecodeModule {
  SpirvModule spirv;      // optimised and valid, like CompileResult::spirv
  SpirvModule untouched;  // vkd3d's module without changes, for counted_module()
  Signature signature;    // locations as in the modules
};

// Returns whether this program was built with vkd3d-shader.
bool translates_bytecode();

// `entry` is the name to give its entry point. Throws std::invalid_argument, with vkd3d's message, for bytes
// that are no shader and for what it does not translate; where translates_bytecode() is false, always.
BytecodeModule bytecode_module(const std::string& bytecode, const std::string& entry);

// Returns its constant buffers as reflect() describes blocks. Throws std::invalid_argument for bytes that are
// no shader.
std::vector<Resource> bytecode_uniforms(const std::string& bytecode);

// The instructions that vkd3d adds to bytecode: they are no operations of the program, and a count of
// operations (counted_module.h) leaves them out.
//
// Bytecode has truth as 0 or all bits, and addresses of buffers and groupshared memory as an element and an
// offset. For SPIR-V, vkd3d turns comparisons into masks and masks into conditions, multiplies and adds
// addresses, and keeps the number of a shift below 32. It stores the result of each instruction of the
// bytecode to a register.
//
// Returns the results of these instructions. `untouched` is BytecodeModule::untouched.
std::set<std::uint32_t> translation_steps(const spirv::Module& untouched);

}  // namespace penumbra::shaders
