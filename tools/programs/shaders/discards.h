// The instructions with which a fragment shader discards its pixel.
#pragma once

#include <optional>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Returns the place of `discard` or `clip` in an optimised module, with line 0 if it has no debug lines. The
// result is empty if there is none.
std::optional<SourcePlace> first_discard(const SpirvModule& module);

}  // namespace penumbra::shaders
