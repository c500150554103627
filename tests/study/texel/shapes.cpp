#include "study/texel/shapes.h"

#include <cmath>
#include <numbers>

namespace penumbra::texel {
namespace {

// An edge, or the middle of a bar, is no farther from the receiver than this.
constexpr double kFarthest = 2.0;
constexpr double kNarrowestBar = 0.5, kWidestBar = 3.0;
constexpr double kSmallestLeaf = 0.5, kLargestLeaf = 2.0, kNarrowestLeaf = 0.3, kRoundestLeaf = 1.0;
constexpr double kLeavesCover = 0.5;  // share of the area

Point direction(Random& random) {
  const double angle = random.between(0.0, 2.0 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}

double along(Point direction, Point point) {
  return direction.x * point.x + direction.y * point.y;
}

template <class Covers>
void draw(Texels& texels, int reach, const Covers& covers) {
  for (int y = -reach; y < reach; ++y)
    for (int x = -reach; x < reach; ++x)
      if (covers(Point{x + 0.5, y + 0.5})) texels.set(x, y, true);
}

void draw_edge(Receiver& receiver, Random& random, int reach) {
  const Point normal = direction(random);
  const double inside = random.between(-kFarthest, kFarthest),
               offset = along(normal, receiver.place) - inside;
  draw(receiver.texels, reach, [&](Point centre) { return along(normal, centre) > offset; });
  for (std::size_t i = 0; i < kRadii.size(); ++i)
    receiver.covered[i] = covered_by_half_plane(inside, kRadii[i]);
}

void draw_bar(Receiver& receiver, Random& random, int reach) {
  const Point normal = direction(random);
  const double half = 0.5 * random.between(kNarrowestBar, kWidestBar);
  const double away = random.between(-kFarthest, kFarthest), middle = along(normal, receiver.place) - away;
  draw(receiver.texels, reach, [&](Point centre) { return std::abs(along(normal, centre) - middle) < half; });
  for (std::size_t i = 0; i < kRadii.size(); ++i)
    receiver.covered[i] =
        covered_by_half_plane(away + half, kRadii[i]) - covered_by_half_plane(away - half, kRadii[i]);
}

std::vector<Ellipse> strewn_leaves(Random& random, double reach) {
  // The mean of the product of the half axes, of which the major one's square and the ratio are independent.
  const double square =
      (kLargestLeaf * kLargestLeaf + kLargestLeaf * kSmallestLeaf + kSmallestLeaf * kSmallestLeaf) / 3.0;
  const double area = std::numbers::pi * square * 0.5 * (kNarrowestLeaf + kRoundestLeaf);
  const double side = reach + kLargestLeaf;
  const double count = -std::log(1.0 - kLeavesCover) / area * 4.0 * side * side;
  std::vector<Ellipse> leaves(static_cast<std::size_t>(random.poisson(count)));
  for (Ellipse& leaf : leaves) {
    leaf.centre.x = random.between(-side, side);
    leaf.centre.y = random.between(-side, side);
    leaf.major = random.between(kSmallestLeaf, kLargestLeaf);
    leaf.minor = leaf.major * random.between(kNarrowestLeaf, kRoundestLeaf);
    leaf.axis = direction(random);
  }
  return leaves;
}

void draw_leaves(Receiver& receiver, Random& random, int reach, int lines) {
  const std::vector<Ellipse> leaves = strewn_leaves(random, reach);
  for (const Ellipse& leaf : leaves) {
    const auto range = [&](double middle, int& from, int& to) {
      from = std::max(static_cast<int>(std::floor(middle - leaf.major)), -reach);
      to = std::min(static_cast<int>(std::ceil(middle + leaf.major)), reach);
    };
    int left = 0, right = 0, bottom = 0, top = 0;
    range(leaf.centre.x, left, right);
    range(leaf.centre.y, bottom, top);
    for (int y = bottom; y < top; ++y)
      for (int x = left; x < right; ++x)
        if (leaf.contains({x + 0.5, y + 0.5})) receiver.texels.set(x, y, true);
  }
  for (std::size_t i = 0; i < kRadii.size(); ++i)
    receiver.covered[i] = covered_by_ellipses(receiver.place, kRadii[i], leaves, lines);
}

}  // namespace

std::string name_of(Kind kind) {
  switch (kind) {
    case Kind::kEdges:
      return "edges";
    case Kind::kBars:
      return "bars";
    case Kind::kLeaves:
      break;
  }
  return "leaves";
}

void Texels::set(int x, int y, bool covered) {
  const auto bit = static_cast<std::uint16_t>(1U << (x + kReach));
  std::uint16_t& row = rows_[y + kReach];
  row = static_cast<std::uint16_t>(covered ? row | bit : row & ~bit);
}

std::uint16_t Texels::block() const {
  unsigned bits = 0;
  for (int y = -2; y < 2; ++y) bits |= (rows_[y + kReach] >> (kReach - 2) & 15U) << (4 * (y + 2));
  return static_cast<std::uint16_t>(bits);
}

Texels Texels::of_block(std::uint16_t block) {
  Texels texels;
  for (int y = -2; y < 2; ++y)
    for (int x = -2; x < 2; ++x) texels.set(x, y, (block >> (4 * (y + 2) + x + 2) & 1) != 0);
  return texels;
}

Receiver drawn(Kind kind, Random& random, int reach, int lines) {
  Receiver receiver{};
  receiver.place.x = random.between(-0.5, 0.5);
  receiver.place.y = random.between(-0.5, 0.5);
  switch (kind) {
    case Kind::kEdges:
      draw_edge(receiver, random, reach);
      break;
    case Kind::kBars:
      draw_bar(receiver, random, reach);
      break;
    case Kind::kLeaves:
      draw_leaves(receiver, random, reach, lines);
      break;
  }
  return receiver;
}

}  // namespace penumbra::texel
