// A SPIR-V module as words. What reads them is in words.h, which brings SPIR-V's enumerations.
#pragma once

#include <cstdint>
#include <vector>

namespace penumbra::spirv {

using Module = std::vector<std::uint32_t>;

}  // namespace penumbra::spirv
