// The module as a driver sees it: one function, SSA values instead of variables, without dead code and dead
// resources, with debug lines. Internal to this folder.
//
// SPIRV-Tools' passes for HLSL legalisation without loop unrolling and without the wrapping of OpKill, so
// that loops and discards are preserved.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace penumbra::lint {

// Nothing if SPIRV-Tools fails.
std::optional<std::vector<std::uint32_t>> legalised(const std::vector<std::uint32_t>& spirv);

// For a module that the compiler has already legalised: the remaining passes.
std::optional<std::vector<std::uint32_t>> simplified(const std::vector<std::uint32_t>& legalised);

}  // namespace penumbra::lint
