// Core/RayBox.hlsl against clipping by one plane after the other in long double.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// The inputs are origin, direction, lowest and highest corner, and length.
const CoreFunction kThrough{"RayBox", "Out2(0, RayThroughBox(In3(0), In3(3), In3(6), In3(9), In(12)));", 13,
                            2};

// Each slab cuts the interval.
std::array<long double, 2> clipped(const float* in) {
  std::array<long double, 2> part{0.0L, in[12]};
  for (int axis = 0; axis < 3; ++axis) {
    const long double origin = in[axis], direction = in[3 + axis], low = in[6 + axis], high = in[9 + axis];
    if (direction == 0.0L) {
      if (origin < low || origin > high) return {0.0L, 0.0L};
      continue;
    }
    const long double a = (low - origin) / direction, b = (high - origin) / direction;
    part = {std::max(part[0], std::min(a, b)), std::min(part[1], std::max(a, b))};
  }
  return part[0] < part[1] ? part : std::array<long double, 2>{0.0L, 0.0L};
}

TEST(RayThroughBox, IsThePartBetweenItsSixPlanes) {
  Random random(31);
  std::vector<float> cases;
  for (int i = 0; i < kRandomCases; ++i) {
    std::array<float, 13> one{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      one[a] = random.between(-3.0f, 3.0f);
      one[3 + a] = random.integer(0, 5) == 0 ? 0.0f : random.between(-1.0f, 1.0f);
      one[6 + a] = random.between(-2.0f, 0.0f);
      one[9 + a] = one[6 + a] + random.between(1.0f, 5.0f);
    }
    one[12] = random.between(0.0f, 10.0f);
    cases.insert(cases.end(), one.begin(), one.end());
  }
  const std::vector<float> seen = run(kThrough, cases);
  int met = 0;
  for (std::size_t i = 0; i < seen.size() / 2; ++i) {
    const auto [from, to] = clipped(&cases[13 * i]);
    if (to > from && to - from < 1e-4L) continue;  // the ray grazes a corner
    ASSERT_NEAR(seen[2 * i], static_cast<double>(from), 1e-4) << i;
    ASSERT_NEAR(seen[2 * i + 1], static_cast<double>(to), 1e-4) << i;
    met += to > from ? 1 : 0;
  }
  EXPECT_GT(met, kRandomCases / 10);
}

TEST(RayThroughSlab, IsAllOfARayAlongItOrNothing) {
  const CoreFunction slab{"RayBox", "Out2(0, RayThroughSlab(In(0), In(1), In(2), In(3)));", 4, 2};
  const std::vector<float> seen = run(slab, {0.0f, 2.0f, 1.0f, 4.0f, 0.0f, -2.0f, 1.0f, 4.0f, 2.0f, 0.0f,
                                             1.0f, 4.0f, 5.0f, 0.0f, 1.0f, 4.0f});
  EXPECT_EQ(std::vector<float>(seen.begin(), seen.begin() + 4),
            (std::vector<float>{0.5f, 2.0f, -2.0f, -0.5f}));
  EXPECT_TRUE(seen[4] < -1e30f && seen[5] > 1e30f) << "inside";
  EXPECT_TRUE(seen[6] > 1e30f && seen[7] < -1e30f) << "beside";
}

TEST(RayThroughBox, IsFiniteAndOrderedForAnyNumbers) {
  Random random(32);
  const std::vector<float> odd = special_floats();
  std::vector<float> cases;
  for (int i = 0; i < 13 * kRandomCases; ++i)
    cases.push_back(random.integer(0, 1) == 0
                        ? odd[static_cast<std::size_t>(random.integer(0, static_cast<int>(odd.size()) - 1))]
                        : random.between(-2.0f, 2.0f));
  const std::vector<float> seen = run(kThrough, cases);
  for (std::size_t i = 0; i < seen.size() / 2; ++i) {
    const float from = seen[2 * i], to = seen[2 * i + 1], length = cases[13 * i + 12];
    ASSERT_TRUE(std::isfinite(from) && std::isfinite(to) && from >= 0.0f && to >= from) << i;
    ASSERT_LE(to, length > 0.0f ? std::min(length, 1e9f) : 0.0f) << i;
    for (std::size_t j = 0; j < 6; ++j) {
      if (std::isfinite(cases[13 * i + j])) continue;
      ASSERT_EQ(to, 0.0f) << "a ray that is none";
    }
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
