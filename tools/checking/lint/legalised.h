// The module as a driver sees it: one function, values instead of variables, dead code and dead resources
// gone, every instruction still with its line. Internal to this room.
//
// SPIRV-Tools' passes for HLSL legalisation without loop unrolling and without the wrapping of OpKill, so
// that loops and discards stay as they were written.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace penumbra::lint {

// Nothing when SPIRV-Tools cannot do it.
std::optional<std::vector<std::uint32_t>> legalised(const std::vector<std::uint32_t>& spirv);

// Of a module that the compiler has legalised: what is left to do.
std::optional<std::vector<std::uint32_t>> simplified(const std::vector<std::uint32_t>& legalised);

}  // namespace penumbra::lint
