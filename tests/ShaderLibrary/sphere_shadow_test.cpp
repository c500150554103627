// Core/SphereShadow.hlsl against rays to all of the disc in long double.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"
#include "ShaderLibrary/long_vectors.h"

namespace penumbra::shader_library_tests {
namespace {

const CoreFunction kShare{"SphereShadow", "Out(0, DiscShareBesideDisc(In(0), In(1), In(2)));", 3, 1};
// The receiver is the origin; the inputs are centre, radius, direction towards the sun, and half its
// diameter.
const CoreFunction kSphere{
    "SphereShadow", "Out(0, SphereVisibility(float3(0.0, 0.0, 0.0), In3(0), In(3), In3(4), In(7)));", 8, 1};

// The share of the first disc's points that lie outside of the other, in rows of 1 / 2000 of it, each
// exactly.
long double counted_share(long double light, long double blocker, long double apart) {
  constexpr int kRows = 2000;
  long double free = 0.0L, all = 0.0L;
  for (int row = 0; row < kRows; ++row) {
    const long double y = light * (2.0L * (row + 0.5L) / kRows - 1.0L);
    const long double half = std::sqrt(light * light - y * y);
    const long double other = blocker * blocker - y * y;
    long double covered = 0.0L;
    if (other > 0.0L) {
      const long double reach = std::sqrt(other);
      covered = std::max(std::min(half, apart + reach) - std::max(-half, apart - reach), 0.0L);
    }
    free += 2.0L * half - covered;
    all += 2.0L * half;
  }
  return free / all;
}

TEST(DiscShareBesideDisc, IsTheAreaOutsideOfTheOther) {
  const std::vector<float> cases = random_cases(
      51,
      [&](Random& random) {
        const float light = std::pow(10.0f, random.between(-2.5f, -0.5f));
        const float blocker = light * std::pow(10.0f, random.between(-1.0f, 1.5f));
        return Case{light, blocker, (light + blocker) * random.between(0.0f, 1.1f)};
      },
      4000);
  const std::vector<float> seen = run(kShare, cases);
  for (std::size_t i = 0; i < seen.size(); ++i)
    ASSERT_NEAR(seen[i], static_cast<double>(counted_share(cases[3 * i], cases[3 * i + 1], cases[3 * i + 2])),
                2e-4)
        << i;
}

TEST(DiscShareBesideDisc, StaysInRangeForAnyNumbers) {
  std::vector<float> cases;
  for (const float light : special_floats())
    for (const float blocker : special_floats())
      for (const float apart : special_floats()) cases.insert(cases.end(), {light, blocker, apart});
  for (const float seen : run(kShare, cases)) ASSERT_TRUE(seen >= 0.0f && seen <= 1.0f);
}

// The rays go over the sun's disc in 64 rings of 64.
long double traced(const float* in) {
  const Vector sun{in[4], in[5], in[6]};
  const Vector axis = std::fabs(in[4]) < std::fabs(in[5]) ? Vector{1, 0, 0} : Vector{0, 1, 0};
  const Vector u = unit(cross(sun, axis)), v = cross(sun, u);
  int free = 0;
  constexpr int kRings = 64;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kRings; ++j) {
      const long double angle = in[7] * std::sqrt((i + 0.5L) / kRings),
                        turn = 2.0L * std::acos(-1.0L) * (j + 0.5L * (i % 2)) / kRings;
      Vector ray{};
      long double along = 0.0L, squared = 0.0L;
      for (std::size_t k = 0; k < 3; ++k) {
        ray[k] = std::cos(angle) * sun[k] + std::sin(angle) * (std::cos(turn) * u[k] + std::sin(turn) * v[k]);
        along += ray[k] * in[k];
        squared += static_cast<long double>(in[k]) * in[k];
      }
      const long double beside = squared - along * along;
      free += along > 0.0L && beside < static_cast<long double>(in[3]) * in[3] ? 0 : 1;
    }
  return static_cast<long double>(free) / (kRings * kRings);
}

TEST(SphereVisibility, IsTheShareOfRaysThatPassTheSphere) {
  Random random(52);
  std::vector<float> cases;
  for (int i = 0; i < 500; ++i) {
    std::array<float, 8> one{};
    float sun = 0.0f;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      one[4 + axis] = random.between(-1.0f, 1.0f);
      sun += one[4 + axis] * one[4 + axis];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) one[4 + axis] /= std::sqrt(sun);
    one[7] = random.between(0.0045f, 0.05f);  // the sun's to 5 degrees
    // The ball lies beside the sun's direction by up to both radii.
    const float distance = random.between(2.0f, 20.0f);
    one[3] = distance * random.between(0.01f, 0.4f);
    for (std::size_t axis = 0; axis < 3; ++axis)
      one[axis] =
          distance * one[4 + axis] + 1.2f * (one[3] + distance * one[7]) * random.between(-1.0f, 1.0f);
    cases.insert(cases.end(), one.begin(), one.end());
  }
  const std::vector<float> seen = run(kSphere, cases);
  int partly = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const long double wanted = traced(&cases[8 * i]);
    ASSERT_NEAR(seen[i], static_cast<double>(wanted), 0.02) << i;
    partly += wanted > 0.02L && wanted < 0.98L ? 1 : 0;
  }
  EXPECT_GT(partly, 100);
}

TEST(SphereVisibility, IsDarkInsideAndLitBeforeASphereBehind) {
  EXPECT_EQ(run(kSphere, {0.1f, 0.0f,  0.0f, 1.0f, 0.0f, 1.0f, 0.0f, 0.005f,    // inside
                          0.0f, -5.0f, 0.0f, 1.0f, 0.0f, 1.0f, 0.0f, 0.005f,    // under the receiver
                          0.0f, 5.0f,  0.0f, 1.0f, 0.0f, 1.0f, 0.0f, 0.005f,    // before the sun
                          0.0f, 5.0f,  0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.005f}),  // without a size
            (std::vector<float>{0.0f, 1.0f, 0.0f, 1.0f}));
  Random random(53);
  const std::vector<float> cases = random_special_floats(random, 8 * kRandomCases);
  for (const float seen : run(kSphere, cases)) ASSERT_TRUE(seen >= 0.0f && seen <= 1.0f);
}

TEST(CircularSegment, IsHalfTheCircleAtItsCentreAndAllOfItBehind) {
  const CoreFunction segment{"SphereShadow", "Out(0, CircularSegment(In(0), In(1), In(2)));", 3, 1};
  const std::vector<float> seen = run(segment, {2.0f, 0.0f, 2.0f, 2.0f, -2.0f, 0.0f, 2.0f, 2.0f, 0.0f});
  const float area = 4.0f * std::acos(-1.0f);
  EXPECT_NEAR(seen[0], 0.5f * area, 1e-5f);
  EXPECT_NEAR(seen[1], area, 1e-5f);
  EXPECT_EQ(seen[2], 0.0f);
  // The segments are thin and thick, of a circle of radius 1.
  std::vector<float> angles, cases;
  for (float angle = 0.001f; angle < 3.1f; angle *= 1.01f) {
    angles.push_back(angle);
    cases.insert(cases.end(), {1.0f, std::cos(angle), std::sin(angle)});
  }
  const std::vector<float> cut = run(segment, cases);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const long double a = angles[i], wanted = a - std::sin(a) * std::cos(a);
    ASSERT_NEAR(cut[i], static_cast<double>(wanted), 1e-4 * static_cast<double>(wanted)) << a;
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
