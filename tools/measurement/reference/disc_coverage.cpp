#include "reference/disc_coverage.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "reference/disc_samples.h"

namespace penumbra::reference {
namespace {

constexpr std::size_t cells = 2048;
constexpr std::uint64_t point_seed = 1;

std::array<std::vector<double>, 2> point_coordinates() {
  std::array<std::vector<double>, 2> coordinates;
  for (std::uint32_t index = 0; index < DiscPoints::count; ++index) {
    const glm::dvec2 point = concentric_disc(scrambled_sobol(index, point_seed));
    coordinates[0].push_back(point.x);
    coordinates[1].push_back(point.y);
  }
  return coordinates;
}

std::size_t cell_of(double coordinate) {
  return static_cast<std::size_t>((coordinate + 1.0) * 0.5 * cells);
}

}  // namespace

DiscPoints::Axis::Axis(const std::vector<double>& coordinates) : first_rank(cells), before(count + 1) {
  std::vector<std::size_t> order(coordinates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t left, std::size_t right) { return coordinates[left] < coordinates[right]; });
  Set points{};
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const std::size_t point = order[rank];
    before[rank] = points;
    points[point / 64] |= std::uint64_t{1} << (point % 64);
    sorted.push_back(coordinates[point]);
    for (std::size_t cell = cell_of(coordinates[point]) + 1; cell < cells; ++cell) {
      first_rank[cell] = static_cast<std::uint16_t>(rank + 1);
    }
  }
  before[order.size()] = points;
}

std::size_t DiscPoints::Axis::points_below(double coordinate) const {
  if (!(coordinate > -1.0)) return 0;
  if (coordinate >= 1.0) return sorted.size();
  std::size_t rank = first_rank[cell_of(coordinate)];
  while (rank < sorted.size() && sorted[rank] < coordinate) ++rank;
  return rank;
}

DiscPoints::DiscPoints() : DiscPoints(point_coordinates()) {}

DiscPoints::DiscPoints(const std::array<std::vector<double>, 2>& coordinates)
    : x_(coordinates[0]), y_(coordinates[1]) {}

void DiscPoints::cover(const DiscRectangle& rectangle, Set& covered) const {
  const std::size_t left = x_.points_below(rectangle.left);
  const std::size_t right = x_.points_below(rectangle.right);
  if (left >= right) return;
  const std::size_t bottom = y_.points_below(rectangle.bottom);
  const std::size_t top = y_.points_below(rectangle.top);
  if (bottom >= top) return;
  const Set& not_left = x_.before[left];
  const Set& up_to_right = x_.before[right];
  const Set& not_below = y_.before[bottom];
  const Set& up_to_top = y_.before[top];
  for (std::size_t word = 0; word < words; ++word) {
    covered[word] |= up_to_right[word] & ~not_left[word] & up_to_top[word] & ~not_below[word];
  }
}

bool DiscPoints::all(const Set& covered) {
  return std::all_of(covered.begin(), covered.end(),
                     [](std::uint64_t word) { return word == ~std::uint64_t{0}; });
}

HalfCounts DiscPoints::uncovered(const Set& covered) {
  const auto zeros = [&](std::size_t begin) {
    int total = 0;
    for (std::size_t word = begin; word < begin + words / 2; ++word) total += std::popcount(~covered[word]);
    return static_cast<std::uint16_t>(total);
  };
  return {zeros(0), zeros(words / 2)};
}

}  // namespace penumbra::reference
