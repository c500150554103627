#include "parameters/disk.h"

#include <array>
#include <cmath>
#include <numbers>

#include "parameters/disk_tables.h"

namespace penumbra::parameters {

namespace {

// The points are computed in long double, so that the float is the same whichever mathematics library rounds
// the last double bit.
DiskPoints golden_spiral(int count, bool scaled) {
  const long double golden_angle = std::numbers::pi_v<long double> * (3.0L - std::sqrt(5.0L));
  DiskPoints points;
  for (int i = 0; i < count; ++i) {
    const long double radius = scaled ? std::sqrt((i + 0.5L) / count) : 1.0L;
    points.emplace_back(static_cast<float>(radius * std::cos(golden_angle * i)),
                        static_cast<float>(radius * std::sin(golden_angle * i)));
  }
  return points;
}

template <std::size_t count>
DiskPoints as_points(const std::array<std::array<float, 2>, count>& table) {
  DiskPoints points;
  for (const auto& entry : table) points.emplace_back(entry[0], entry[1]);
  return points;
}

}  // namespace

DiskPoints fibonacci_directions(int count) {
  return golden_spiral(count, false);
}
DiskPoints vogel_disk(int count) {
  return golden_spiral(count, true);
}

DiskPoints poisson_disk(int count) {
  switch (count) {
    case 25:
      return as_points(disk_tables::kPoisson25);
    case 32:
      return as_points(disk_tables::kPoisson32);
    case 64:
      return as_points(disk_tables::kPoisson64);
    case 100:
      return as_points(disk_tables::kPoisson100);
    case 128:
      return as_points(disk_tables::kPoisson128);
    default:
      return {};
  }
}

}  // namespace penumbra::parameters
