// Point sets on the light's disc for ray tracing: independent, low-discrepancy, uniform by area.
//
// Each set is the first 2^k points of the two-dimensional Sobol sequence under its own Owen scrambling (Owen,
// "Randomly permuted (t,m,s)-nets", 1995), mapped to the unit disc by the concentric map (Shirley & Chiu,
// "A low distortion map between disk and square", 1997). Every set alone gives an unbiased estimate; at an
// edge across the disc its error falls like n^(-3/4) rather than n^(-1/2). Points are sorted along a Morton
// curve, so that consecutive ones make coherent ray packets. The same seed gives the same points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace penumbra::reference {

// A well-mixed 64-bit value of any number (SplitMix64's finaliser; Steele, Lea & Flood 2014).
std::uint64_t mixed_bits(std::uint64_t number);

// The point with this index of the Owen-scrambled Sobol sequence, in [0, 1)^2.
glm::dvec2 scrambled_sobol(std::uint32_t index, std::uint64_t seed);

// Unit square to unit disc, areas kept in proportion.
glm::dvec2 concentric_disc(const glm::dvec2& square);

class DiscSamples {
 public:
  static constexpr std::size_t set_count = 64;

  // points_per_set: a power of two.
  DiscSamples(std::size_t points_per_set, std::uint64_t seed);

  std::size_t points_per_set() const { return points_per_set_; }
  std::span<const float> x(std::size_t set) const { return {&x_[set * points_per_set_], points_per_set_}; }
  std::span<const float> y(std::size_t set) const { return {&y_[set * points_per_set_], points_per_set_}; }

 private:
  std::size_t points_per_set_;
  std::vector<float> x_;
  std::vector<float> y_;
};

}  // namespace penumbra::reference
