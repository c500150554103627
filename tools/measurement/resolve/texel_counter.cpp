#include "resolve/texel_counter.h"

#include <cstddef>
#include <span>
#include <stdexcept>

#include "shaders/counted_module.h"

namespace penumbra::resolve {
namespace {

std::vector<std::uint32_t> zeroed(int width, int height, int depth) {
  if (width < 1 || height < 1 || depth < 1) throw std::invalid_argument("a grid of counts without a cell");
  const std::size_t cells =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(depth);
  std::vector<std::uint32_t> words(shaders::texel_counts_header + shaders::texel_counts_per_cell * cells, 0);
  words[0] = static_cast<std::uint32_t>(width);
  words[1] = static_cast<std::uint32_t>(height);
  words[2] = static_cast<std::uint32_t>(depth);
  return words;
}

std::uint64_t long_at(const std::vector<std::uint32_t>& words, std::size_t low) {
  return words[low] | static_cast<std::uint64_t>(words[low + 1]) << 32U;
}

}  // namespace

TexelCounter::TexelCounter(const gpu::Device& device, int width, int height, int depth)
    : buffer_(device, std::span<const std::uint32_t>(zeroed(width, height, depth))) {}

TexelCounts TexelCounter::counts() const {
  const std::vector<std::uint32_t> words = buffer_.download<std::uint32_t>();
  TexelCounts counts;
  counts.invocations = words[shaders::texel_counts_invocations];
  counts.barriers = long_at(words, shaders::texel_counts_barriers);
  for (std::size_t i = shaders::texel_counts_header; i < words.size(); i += shaders::texel_counts_per_cell) {
    counts.fetches.push_back(words[i]);
    counts.written.push_back(words[i + 1]);
    counts.operations.push_back(long_at(words, i + 2));
    counts.bytes_read.push_back(long_at(words, i + 4));
    counts.bytes_written.push_back(long_at(words, i + 6));
  }
  return counts;
}

}  // namespace penumbra::resolve
