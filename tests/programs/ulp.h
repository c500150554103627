// The distance of two floats.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdlib>

namespace penumbra::programs {

// The number of floats between both and one more, given as bits; 0 for the two zeros.
inline std::int64_t ulps_apart(std::uint32_t a, std::uint32_t b) {
  const auto place = [](std::uint32_t bits) {
    const auto size = static_cast<std::int64_t>(bits & 0x7FFFFFFFU);
    return (bits >> 31U) != 0 ? -size : size;
  };
  return std::llabs(place(a) - place(b));
}

}  // namespace penumbra::programs
