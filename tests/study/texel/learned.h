// Learns what many receivers tell about each pattern of 4 x 4 bits: the bound of what any filter of that
// footprint can reach.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "study/texel/shapes.h"

namespace penumbra::texel {

// A receiver's place and block, turned and mirrored so that 0 <= y <= x.
struct Canonical {
  Point place;
  std::uint16_t block;
};
Canonical canonical(Point place, std::uint16_t block);

// Fits for each block a cubic of the place, by least squares to the covered share less the shipped kernel's.
// What a block's receivers do not tell stays at the kernel's.
class TrainingSums {
 public:
  // penumbra says whether only receivers count of which the disc is partly covered, or all.
  explicit TrainingSums(bool penumbra);
  void add(const Receiver& receiver);
  void add(const TrainingSums& others);

 private:
  friend class Learned;
  static constexpr std::size_t kTerms = 10;
  struct OfBlock {
    std::array<std::array<double, kTerms*(kTerms + 1) / 2>, kRadii.size()> squares{};
    std::array<std::array<double, kTerms>, kRadii.size()> products{};
  };
  bool penumbra_;
  std::vector<std::unique_ptr<OfBlock>> blocks_;  // sums by block, where there is one
};

class Learned {
 public:
  explicit Learned(const TrainingSums& sums);
  double covered(Point place, std::uint16_t block, std::size_t radius) const;

 private:
  using Cubic = std::array<float, TrainingSums::kTerms>;
  std::vector<std::unique_ptr<std::array<Cubic, kRadii.size()>>> blocks_;
};

// The radius of the kernel that is learned to be corrected.
double learned_kernel(std::size_t radius);

}  // namespace penumbra::texel
