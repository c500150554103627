// The module as a driver sees it: one function, SSA values instead of variables, without dead code and dead
// resources, with debug lines. Internal to this folder.
//
// It is made by SPIRV-Tools' passes for HLSL legalisation without loop unrolling and without the wrapping of
// OpKill, so that loops and discards are preserved.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace penumbra::lint {

// Returns nothing if SPIRV-Tools fails.
std::optional<std::vector<std::uint32_t>> legalised(const std::vector<std::uint32_t>& spirv);

// Runs the remaining passes on a module that the compiler has already legalised.
std::optional<std::vector<std::uint32_t>> simplified(const std::vector<std::uint32_t>& legalised);

}  // namespace penumbra::lint
