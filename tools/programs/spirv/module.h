// A SPIR-V module as 32-bit words. words.h, which includes SPIR-V's enumerations, reads them.
#pragma once

#include <cstdint>
#include <vector>

namespace penumbra::spirv {

using Module = std::vector<std::uint32_t>;

}  // namespace penumbra::spirv
