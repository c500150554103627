// The numbers of instructions of a SPIR-V module, by category: a count that does not depend on a driver.
//
// Based on the SPIR-V specification 1.6, section 3 "Instructions". The count has the instructions in function
// bodies that compute or move something: labels, merge declarations, variables, undefined values and debug
// lines do not count. Loops count once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace penumbra::cost {

struct SpirvCounts {
  std::size_t instructions = 0;  // total, of which:
  std::size_t alu = 0;      // arithmetic, conversion, comparison, selection, bits, derivatives, GLSL.std.450
  std::size_t texture = 0;  // samples, fetches, gathers, reads, writes and queries of images
  std::size_t memory = 0;   // loads, stores, addresses, atomics
  std::size_t control = 0;  // branches, phis, calls, returns, kills
  // The remaining instructions construct and extract composites.

  bool operator==(const SpirvCounts&) const = default;
};

// Throws std::invalid_argument for words that are no SPIR-V.
SpirvCounts count_spirv(const std::vector<std::uint32_t>& spirv);

}  // namespace penumbra::cost
