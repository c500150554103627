// The resources, inputs and outputs of FXC's bytecode, in the terms of reflect.h and stage_signature.h.
// Internal to this folder.
#pragma once

#include <string_view>

#include "shaders/reflect.h"
#include "shaders/spirv_module.h"
#include "shaders/stage_signature.h"

namespace penumbra::shaders {

enum class RegisterKind { constants, texture, writable, sampler };  // b, t, u, s

struct BytecodeResource {
  Resource resource;  // name, kind and, of a uniform block, size and members; "$Global" as reflect() has it
  RegisterKind registers = RegisterKind::constants;
  std::uint32_t index = 0;  // its register
  bool buffer = false;      // a buffer of texels, structures or bytes: no image
};

// These throw std::invalid_argument for bytes that are not a container's, and for arrays of resources.
std::vector<BytecodeResource> bytecode_resources(std::string_view bytecode);
Signature bytecode_signature(std::string_view bytecode);  // locations are registers

// The call of vkd3d-shader, or its replacement where it is not installed.
//
// Resource n of `resources` has descriptor set 0 and binding n. Throws as bytecode_module() does.
SpirvModule translated_bytecode(const std::string& bytecode, const std::vector<BytecodeResource>& resources);

}  // namespace penumbra::shaders
