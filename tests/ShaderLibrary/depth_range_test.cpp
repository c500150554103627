// Map/DepthRange.hlsl: ranges stay on their side of what they bound, also in 16-bit integers; which cells a
// circular dilation has, and how far it reaches.
#include <algorithm>
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

CoreFunction depth_range(const std::string& statement, int inputs, int outputs) {
  return function_in("Map", "DepthRange", statement, inputs, outputs);
}

// The depths are every step of the format and the floats around it, and a million others.
std::vector<float> depths_near_steps() {
  std::vector<float> depths;
  for (int step = 0; step <= 65535; ++step) {
    const float at = static_cast<float>(step / 65535.0L);
    float below = at, above = at;
    depths.push_back(at);
    for (int i = 0; i < 3; ++i) {
      below = std::nextafter(below, 0.0f);
      above = std::nextafter(above, 1.0f);
      depths.push_back(below);
      depths.push_back(above);
    }
  }
  Random random(71);
  for (int i = 0; i < 1000000; ++i) depths.push_back(random.between(0.0f, 1.0f));
  for (int i = 0; i < kRandomCases; ++i) depths.push_back(std::fabs(random.magnitude(-40.0f, 0.0f)));
  for (float& depth : depths) depth = std::clamp(depth, 0.0f, 1.0f);
  return depths;
}

TEST(DepthRange, RoundsOutwardInAFormatOf16Bits) {
  const std::vector<float> depths = depths_near_steps();
  for (const DepthDirection direction : kDepthDirections) {
    const std::vector<float> out =
        run(depth_range("Out2(0, RoundRangeOutward(float2(In(0), In(0))));", 1, 2), direction, depths);
    const long double toward_light = direction == DepthDirection::reversed ? 1.0L : -1.0L;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        const long double outward = k == 0 ? toward_light : -toward_light;
        const long double steps = 65535.0L * out[2 * i + k];
        ASSERT_NEAR(static_cast<double>(steps), static_cast<double>(std::round(steps)), 0.01) << depths[i];
        // A device makes this of the stored integer: its quotient, rounded to a float in any way, twice.
        const auto exact = static_cast<float>(std::round(steps) / 65535.0L);
        const float inward =
            std::nextafter(std::nextafter(exact, outward > 0 ? 0.0f : 1.0f), outward > 0 ? 0.0f : 1.0f);
        const long double beyond = outward * (static_cast<long double>(inward) - depths[i]);
        const bool at_the_end = exact == (outward > 0 ? 1.0f : 0.0f);
        ASSERT_TRUE(beyond >= 0.0L || at_the_end) << depths[i] << ", bound " << exact << ", " << k;
        ASSERT_LE(outward * (static_cast<long double>(exact) - depths[i]) * 65535.0L, 1.02L) << depths[i];
      }
    }
  }
}

TEST(DepthRange, JoinsHaveTheNearestAndTheFarthest) {
  Random random(72);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i)
    for (int k = 0; k < 8; ++k) inputs.push_back(random.between(0.0f, 1.0f));
  for (const DepthDirection direction : kDepthDirections) {
    const std::vector<float> out = run(
        depth_range("Out2(0, JoinRanges(JoinRanges(kEmptyRange, RangeOfFour(In4(0))), RangeOfFour(In4(4))));",
                    8, 2),
        direction, inputs);
    for (std::size_t i = 0; i < inputs.size() / 8; ++i) {
      const auto first = inputs.begin() + static_cast<std::ptrdiff_t>(8 * i);
      const auto [least, most] = std::minmax_element(first, first + 8);
      const bool reversed = direction == DepthDirection::reversed;
      ASSERT_EQ(out[2 * i], reversed ? *most : *least) << i;
      ASSERT_EQ(out[2 * i + 1], reversed ? *least : *most) << i;
    }
  }
}

// The source lists the texels in this way: rows of floor(sqrt(r^2 - y^2)) texels to each side.
bool listed(int x, int y, int radius) {
  if (std::abs(y) > radius) return false;
  int half = 0;
  while ((half + 1) * (half + 1) <= radius * radius - y * y) ++half;
  return std::abs(x) <= half;
}

TEST(DepthRange, ADilationHasTheCellsOfItsDisc) {
  std::vector<float> inputs;
  for (int radius = 0; radius <= 16; ++radius)
    for (int y = -18; y <= 18; ++y)
      for (int x = -18; x <= 18; ++x) inputs.insert(inputs.end(), {float(x), float(y), float(radius)});
  const std::vector<float> out =
      run(depth_range("OutInt(0, InDilation(int2(InInt(0), InInt(1)), InInt(2)) ? 1 : 0);", 3, 1), inputs);
  std::vector<int> cells(17);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int radius = static_cast<int>(inputs[3 * i + 2]);
    ASSERT_EQ(out[i] != 0.0f,
              listed(static_cast<int>(inputs[3 * i]), static_cast<int>(inputs[3 * i + 1]), radius));
    cells[static_cast<std::size_t>(radius)] += out[i] != 0.0f ? 1 : 0;
  }
  EXPECT_EQ(cells[8], 197);
  EXPECT_EQ(cells[4], 49);
  EXPECT_EQ(cells[3], 29);
  EXPECT_EQ(cells[0], 1);
}

// The distance between the nearest points of the middle cell and of the nearest cell that is left out, in
// cells.
double distance_left_out(int radius) {
  double nearest = 1e9;
  for (int y = -20; y <= 20; ++y)
    for (int x = -20; x <= 20; ++x)
      if (!listed(x, y, radius))
        nearest = std::min(nearest, std::hypot(std::max(std::abs(x) - 1, 0), std::max(std::abs(y) - 1, 0)));
  return nearest;
}

TEST(DepthRange, ADilationReachesNoFartherThanItsCells) {
  std::vector<float> radii;
  for (int radius = 0; radius <= 16; ++radius) radii.push_back(static_cast<float>(radius));
  const std::vector<float> reach = run(depth_range("Out(0, DilationReach(InInt(0)));", 1, 1), radii);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double covered = 4.0 * distance_left_out(static_cast<int>(i));
    EXPECT_LE(reach[i], covered) << "radius " << i;
    EXPECT_GE(reach[i], covered - 4.0) << "radius " << i << ": no more than a cell is given away";
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
