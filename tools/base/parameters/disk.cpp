#include "parameters/disk.h"

#include <cmath>
#include <iterator>
#include <numbers>

namespace penumbra::parameters {

namespace {

// The tables that shaders read are C++, too.
using float2 = glm::vec2;
#include "DiskTables.hlsl"

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
DiskPoints as_points(const float2 (&table)[count]) {
  return {std::begin(table), std::end(table)};
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
      return as_points(kPenumbraPoisson25);
    case 32:
      return as_points(kPenumbraPoisson32);
    case 64:
      return as_points(kPenumbraPoisson64);
    case 100:
      return as_points(kPenumbraPoisson100);
    case 128:
      return as_points(kPenumbraPoisson128);
    default:
      return {};
  }
}

}  // namespace penumbra::parameters
