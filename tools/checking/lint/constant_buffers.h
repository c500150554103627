// The constant buffers a module declares: names, members, offsets. Internal to this folder; program_rules.h
// offers them to callers.
#pragma once

#include <vector>

#include "lint/program_rules.h"
#include "spirv/code.h"

namespace penumbra::lint {

// `block_type` is the block's struct type.
ConstantBuffer constant_buffer(const spirv::Code& code, spirv::Id block_type);

}  // namespace penumbra::lint
