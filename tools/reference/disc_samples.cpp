#include "reference/disc_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penumbra::reference {
namespace {

std::uint32_t reversed_bits(std::uint32_t bits) {
  std::uint32_t reversed = 0;
  for (int bit = 0; bit < 32; ++bit) reversed |= ((bits >> bit) & 1U) << (31 - bit);
  return reversed;
}

// Second Sobol dimension: generator matrix of Pascal's triangle modulo two.
std::uint32_t sobol_second(std::uint32_t index) {
  std::uint32_t value = 0;
  for (std::uint32_t column = 1U << 31; index != 0; index >>= 1, column ^= column >> 1) {
    if ((index & 1U) != 0) value ^= column;
  }
  return value;
}

// Owen's nested scrambling: each bit flips by a coin that belongs to the bits above it.
std::uint32_t owen_scrambled(std::uint32_t value, std::uint64_t seed) {
  std::uint32_t scrambled = 0;
  for (int bit = 31; bit >= 0; --bit) {
    const std::uint64_t above = bit == 31 ? 0 : value >> (bit + 1);
    const std::uint64_t coin = mixed_bits(seed ^ mixed_bits((above << 5) | static_cast<unsigned>(bit)));
    scrambled |= (((value >> bit) ^ static_cast<std::uint32_t>(coin >> 63)) & 1U) << bit;
  }
  return scrambled;
}

// Interleaves the upper 16 bits of both coordinates.
std::uint32_t morton_place(const glm::dvec2& square) {
  const auto across = static_cast<std::uint32_t>(square.x * 65536.0);
  const auto along = static_cast<std::uint32_t>(square.y * 65536.0);
  std::uint32_t place = 0;
  for (int bit = 0; bit < 16; ++bit) {
    place |= ((across >> bit) & 1U) << (2 * bit) | ((along >> bit) & 1U) << (2 * bit + 1);
  }
  return place;
}

}  // namespace

std::uint64_t mixed_bits(std::uint64_t number) {
  number += 0x9E3779B97F4A7C15ULL;
  number = (number ^ (number >> 30)) * 0xBF58476D1CE4E5B9ULL;
  number = (number ^ (number >> 27)) * 0x94D049BB133111EBULL;
  return number ^ (number >> 31);
}

glm::dvec2 scrambled_sobol(std::uint32_t index, std::uint64_t seed) {
  const std::uint32_t first = owen_scrambled(reversed_bits(index), mixed_bits(2 * seed));
  const std::uint32_t second = owen_scrambled(sobol_second(index), mixed_bits(2 * seed + 1));
  return {std::ldexp(first, -32), std::ldexp(second, -32)};
}

glm::dvec2 concentric_disc(const glm::dvec2& square) {
  const glm::dvec2 centred = 2.0 * square - 1.0;
  if (centred.x == 0.0 && centred.y == 0.0) return {0.0, 0.0};
  const bool across = std::abs(centred.x) > std::abs(centred.y);
  const double radius = across ? centred.x : centred.y;
  const double angle = across ? std::numbers::pi / 4.0 * (centred.y / centred.x)
                              : std::numbers::pi / 2.0 - std::numbers::pi / 4.0 * (centred.x / centred.y);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

DiscSamples::DiscSamples(std::size_t points_per_set, std::uint64_t seed)
    : points_per_set_(points_per_set), x_(set_count * points_per_set), y_(set_count * points_per_set) {
  std::vector<glm::dvec2> squares(points_per_set);
  for (std::size_t set = 0; set < set_count; ++set) {
    const std::uint64_t set_seed = mixed_bits(mixed_bits(seed) + set);
    for (std::uint32_t index = 0; index < points_per_set; ++index) {
      squares[index] = scrambled_sobol(index, set_seed);
    }
    std::sort(squares.begin(), squares.end(), [](const glm::dvec2& left, const glm::dvec2& right) {
      return morton_place(left) < morton_place(right);
    });
    for (std::size_t index = 0; index < points_per_set; ++index) {
      const glm::dvec2 point = concentric_disc(squares[index]);
      x_[set * points_per_set + index] = static_cast<float>(point.x);
      y_[set * points_per_set + index] = static_cast<float>(point.y);
    }
  }
}

}  // namespace penumbra::reference
