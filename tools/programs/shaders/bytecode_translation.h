// The call of vkd3d-shader, or its replacement where it is not installed. Internal to this folder.
#pragma once

#include <string>
#include <vector>

#include "shaders/bytecode_reflection.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Resource n of `resources` has descriptor set 0 and binding n. Throws as bytecode_module() does.
SpirvModule translated_bytecode(const std::string& bytecode, const std::vector<BytecodeResource>& resources);

}  // namespace penumbra::shaders
