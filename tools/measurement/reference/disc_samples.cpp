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

// The second Sobol dimension has Pascal's triangle modulo two as its generator matrix.
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

DiscSamples::DiscSamples(std::size_t points_per_pair, std::uint64_t seed)
    : points_per_pair_(points_per_pair),
      seed_(mixed_bits(seed)),
      x_(pair_count * points_per_pair),
      y_(pair_count * points_per_pair) {
  for (std::size_t pair = 0; pair < pair_count; ++pair) {
    place_set(pair, 0);
    place_set(pair, 1);
  }
}

void DiscSamples::place_set(std::size_t pair, std::size_t half) {
  const std::uint64_t set_seed = mixed_bits(seed_ + 2 * pair + half);
  std::vector<glm::dvec2> squares(points_per_pair_ / 2);
  for (std::uint32_t index = 0; index < squares.size(); ++index) {
    squares[index] = scrambled_sobol(index, set_seed);
  }
  std::sort(squares.begin(), squares.end(), [](const glm::dvec2& left, const glm::dvec2& right) {
    return morton_place(left) < morton_place(right);
  });
  for (std::size_t index = 0; index < squares.size(); ++index) {
    const std::size_t packet = index / half_packet;
    const std::size_t lane = half * half_packet + index % half_packet;
    const std::size_t place = pair * points_per_pair_ + packet * 2 * half_packet + lane;
    const glm::dvec2 point = concentric_disc(squares[index]);
    x_[place] = static_cast<float>(point.x);
    y_[place] = static_cast<float>(point.y);
  }
}

PixelDraw DiscSamples::draw(std::size_t pixel) const {
  const std::uint64_t bits = mixed_bits(seed_ ^ mixed_bits(pixel));
  return {bits % pair_count, std::ldexp(static_cast<double>(bits >> 32), -32) * 2.0 * std::numbers::pi};
}

}  // namespace penumbra::reference
