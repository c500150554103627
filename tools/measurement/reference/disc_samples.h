// Point sets on the light's disc for ray tracing: independent, low-discrepancy, uniform by area.
//
// Each set is the first 2^k points of the two-dimensional Sobol sequence under its own Owen scrambling (Owen,
// "Randomly permuted (t,m,s)-nets", 1995), mapped to the unit disc by the concentric map (Shirley & Chiu,
// "A low distortion map between disk and square", 1997). Every set alone gives an unbiased estimate; at an
// edge across the disc its error falls like n^(-3/4) rather than n^(-1/2). The same seed gives the same
// points.
//
// A pair is two such sets, shuffled for packets of sixteen rays: eight points of the first set, then eight of
// the second out of the same cell of the disc. Each set is sorted along a Morton curve; being nets, both have
// eight points in each of the curve's cells, so packets are coherent and the halves stay apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace penumbra::reference {

// Returns a well-mixed 64-bit value of any number (SplitMix64's finaliser; Steele, Lea & Flood 2014).
std::uint64_t mixed_bits(std::uint64_t number);

// Returns the point with this index of the Owen-scrambled Sobol sequence, in [0, 1)^2.
glm::dvec2 scrambled_sobol(std::uint32_t index, std::uint64_t seed);

// Maps the unit square to the unit disc and keeps areas in proportion.
glm::dvec2 concentric_disc(const glm::dvec2& square);

// The choice of one pixel's points: the number of its pair, and the angle (radians) by which the pair is
// turned.
struct PixelDraw {
  std::size_t pair = 0;
  double angle = 0.0;
};

class DiscSamples {
 public:
  static constexpr std::size_t pair_count = 64;
  static constexpr std::size_t half_packet = 8;

  // points_per_pair is a power of two, at least 32.
  DiscSamples(std::size_t points_per_pair, std::uint64_t seed);

  std::size_t points_per_pair() const { return points_per_pair_; }
  const float* x(std::size_t pair) const { return &x_[pair * points_per_pair_]; }
  const float* y(std::size_t pair) const { return &y_[pair * points_per_pair_]; }

  PixelDraw draw(std::size_t pixel) const;

 private:
  void place_set(std::size_t pair, std::size_t half);

  std::size_t points_per_pair_;
  std::uint64_t seed_;
  std::vector<float> x_;
  std::vector<float> y_;
};

}  // namespace penumbra::reference
