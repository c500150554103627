// Where a fragment shader gives its pixel up.
#pragma once

#include <optional>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// `discard` or `clip` of an optimised module; line 0 in a module without debug lines. Empty: there is none.
std::optional<SourcePlace> first_discard(const SpirvModule& module);

}  // namespace penumbra::shaders
