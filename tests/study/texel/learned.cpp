#include "study/texel/learned.h"

#include <algorithm>
#include <cmath>

#include "study/texel/estimators.h"

namespace penumbra::texel {
namespace {

constexpr std::size_t kBlocks = 1U << 16;
// The kernel counts like this many receivers.
constexpr double kPriorWeight = 2.0;

// The terms go from -1 to 1 each, so that all weigh about the same.
std::array<double, 10> terms(Point place) {
  const double x = 4.0 * place.x - 1.0, y = 4.0 * place.y - 1.0;
  return {1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
}

std::uint16_t permuted(std::uint16_t block, bool mirror_x, bool mirror_y, bool swap) {
  unsigned bits = 0;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      int from_x = swap ? y : x, from_y = swap ? x : y;
      if (mirror_x) from_x = 3 - from_x;
      if (mirror_y) from_y = 3 - from_y;
      bits |= (block >> (4 * from_y + from_x) & 1U) << (4 * y + x);
    }
  return static_cast<std::uint16_t>(bits);
}

// Solves a symmetric positive definite system, by Cholesky; the lower triangle is given row by row.
template <std::size_t N>
std::array<double, N> solved(std::array<double, N*(N + 1) / 2> lower, std::array<double, N> right) {
  const auto at = [&](std::size_t row, std::size_t column) -> double& {
    return lower[row * (row + 1) / 2 + column];
  };
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = at(i, j);
      for (std::size_t k = 0; k < j; ++k) sum -= at(i, k) * at(j, k);
      at(i, j) = i == j ? std::sqrt(sum) : sum / at(j, j);
    }
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= at(i, k) * right[k];
    right[i] /= at(i, i);
  }
  for (std::size_t i = N; i-- > 0;) {
    for (std::size_t k = i + 1; k < N; ++k) right[i] -= at(k, i) * right[k];
    right[i] /= at(i, i);
  }
  return right;
}

}  // namespace

Canonical canonical(Point place, std::uint16_t block) {
  const bool mirror_x = place.x < 0.0, mirror_y = place.y < 0.0;
  Point turned{std::abs(place.x), std::abs(place.y)};
  const bool swap = turned.y > turned.x;
  if (swap) std::swap(turned.x, turned.y);
  return {turned, permuted(block, mirror_x, mirror_y, swap)};
}

double learned_kernel(std::size_t radius) {
  return kRadii[radius] < 1.0 ? 1.0 : 1.25;
}

TrainingSums::TrainingSums(bool penumbra) : penumbra_(penumbra), blocks_(kBlocks) {}

void TrainingSums::add(const Receiver& receiver) {
  const Canonical seen = canonical(receiver.place, receiver.texels.block());
  std::unique_ptr<OfBlock>& block = blocks_[seen.block];
  const Texels texels = Texels::of_block(seen.block);
  const std::array<double, kTerms> own = terms(seen.place);
  for (std::size_t i = 0; i < kRadii.size(); ++i) {
    if (penumbra_ && !receiver.in_penumbra(i)) continue;
    if (!block) block = std::make_unique<OfBlock>();
    const double missing = receiver.covered[i] - shipped_kernel(seen.place, texels, learned_kernel(i));
    std::size_t next = 0;
    for (std::size_t row = 0; row < kTerms; ++row) {
      block->products[i][row] += missing * own[row];
      for (std::size_t column = 0; column <= row; ++column)
        block->squares[i][next++] += own[row] * own[column];
    }
  }
}

void TrainingSums::add(const TrainingSums& others) {
  const auto sum = [](auto& all, const auto& more) {
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < all[i].size(); ++k) all[i][k] += more[i][k];
  };
  for (std::size_t i = 0; i < kBlocks; ++i) {
    if (!others.blocks_[i]) continue;
    if (!blocks_[i]) blocks_[i] = std::make_unique<OfBlock>();
    sum(blocks_[i]->squares, others.blocks_[i]->squares);
    sum(blocks_[i]->products, others.blocks_[i]->products);
  }
}

Learned::Learned(const TrainingSums& sums) : blocks_(kBlocks) {
  for (std::size_t i = 0; i < kBlocks; ++i) {
    if (!sums.blocks_[i]) continue;
    blocks_[i] = std::make_unique<std::array<Cubic, kRadii.size()>>();
    for (std::size_t radius = 0; radius < kRadii.size(); ++radius) {
      auto squares = sums.blocks_[i]->squares[radius];
      for (std::size_t row = 0; row < TrainingSums::kTerms; ++row)
        squares[row * (row + 3) / 2] += kPriorWeight;
      const auto cubic = solved<TrainingSums::kTerms>(squares, sums.blocks_[i]->products[radius]);
      std::copy(cubic.begin(), cubic.end(), (*blocks_[i])[radius].begin());
    }
  }
}

double Learned::covered(Point place, std::uint16_t block, std::size_t radius) const {
  const Canonical seen = canonical(place, block);
  double covered = shipped_kernel(seen.place, Texels::of_block(seen.block), learned_kernel(radius));
  if (blocks_[seen.block]) {
    const std::array<double, 10> own = terms(seen.place);
    for (std::size_t i = 0; i < own.size(); ++i)
      covered += static_cast<double>((*blocks_[seen.block])[radius][i]) * own[i];
  }
  return std::clamp(covered, 0.0, 1.0);
}

}  // namespace penumbra::texel
