// Random blockers of one height, as the shadow map and a receiver see them.
#pragma once

#include <array>
#include <string>

#include "study/texel/geometry.h"

namespace penumbra::texel {

enum class Kind { kEdges, kBars, kLeaves };
inline constexpr std::array kKinds{Kind::kEdges, Kind::kBars, Kind::kLeaves};
std::string name_of(Kind kind);

// Radii of the light's disc on the blocker's plane, as seen from the receiver.
inline constexpr std::array kRadii{0.25, 0.5, 1.0};

// The map's texels, each a bit: whether the blocker covers its centre. Texel (x, y) is the square from (x, y)
// to (x + 1, y + 1); the middle of the window is at (0, 0).
class Texels {
 public:
  static constexpr int kReach = 8;

  bool covers(int x, int y) const { return (rows_[y + kReach] >> (x + kReach) & 1) != 0; }
  void set(int x, int y, bool covered);
  // The 4 x 4 texels around the middle, row by row, the lowest bit first.
  std::uint16_t block() const;
  static Texels of_block(std::uint16_t block);  // the others are clear

 private:
  std::array<std::uint16_t, 2 * kReach> rows_{};
};

// A receiver lies within half a texel of (0, 0), because the middle four texels are those that bilinear
// filtering weighs for it.
struct Receiver {
  Point place;
  Texels texels;
  std::array<double, kRadii.size()> covered;  // share of the disc of each radius

  bool in_penumbra(std::size_t radius) const {
    return covered[radius] > 1e-9 && covered[radius] < 1.0 - 1e-9;
  }
};

// reach is how many texels from the middle are drawn, 2 to Texels::kReach; the others are clear. lines across
// a disc integrate what leaves cover.
Receiver drawn(Kind kind, Random& random, int reach, int lines);

}  // namespace penumbra::texel
