// SPIR-V of FXC's bytecode, by vkd3d-shader: what Unity's compiler makes, in a form that a Vulkan device
// runs.
//
// The module has the names, the entry point and the kinds of resources that compile() gives the same HLSL, so
// that a host binds both alike; but vkd3d knows a constant buffer as registers alone, so that its members
// come beside the module.
#pragma once

#include <string>
#include <vector>

#include "shaders/reflect.h"
#include "shaders/spirv_module.h"
#include "shaders/stage_signature.h"

namespace penumbra::shaders {

struct BytecodeModule {
  SpirvModule spirv;      // optimised and valid, as CompileResult::spirv
  SpirvModule untouched;  // as vkd3d made it, for counted_module()
  Signature signature;    // locations as in the modules
};

// Whether this program was built with vkd3d-shader.
bool translates_bytecode();

// `entry`: the name to give its entry point. Throws std::invalid_argument, with vkd3d's message, for bytes
// that are no shader and for what it does not translate; where translates_bytecode() is false, always.
BytecodeModule bytecode_module(const std::string& bytecode, const std::string& entry);

// Its constant buffers as reflect() describes blocks. Throws std::invalid_argument for bytes that are no
// shader.
std::vector<Resource> bytecode_uniforms(const std::string& bytecode);

}  // namespace penumbra::shaders
