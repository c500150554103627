// Counts of fetches, texels, bytes, operations and barriers on a device: the buffer that a counted module
// adds to (shaders/counted_module.h).
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/resources.h"

namespace penumbra::resolve {

// The counts of each cell of the grid, x first, then y and z. For a fragment shader a cell is a pixel of its
// target, for a compute shader a value of SV_DispatchThreadID.
struct TexelCounts {
  std::vector<std::uint32_t> fetches;
  std::vector<std::uint32_t> written;
  std::vector<std::uint64_t> operations;  // scalar operations, executed
  std::vector<std::uint64_t> bytes_read;
  std::vector<std::uint64_t> bytes_written;
  std::uint32_t invocations = 0;  // total of the grid: threads, or fragments that are not helpers
  std::uint64_t barriers = 0;     // total of these
};

class TexelCounter {
 public:
  // All counts begin at 0. A grid of one cell has the totals of any pass, fetches and texels up to 2^32 - 1.
  // Throws std::invalid_argument for an extent below 1.
  explicit TexelCounter(const gpu::Device& device, int width = 1, int height = 1, int depth = 1);

  // It is bound under the name shaders::texel_counts_name.
  const gpu::Buffer& buffer() const { return buffer_; }

  TexelCounts counts() const;

 private:
  gpu::Buffer buffer_;
};

}  // namespace penumbra::resolve
