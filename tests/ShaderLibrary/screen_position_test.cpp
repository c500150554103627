// Core/ScreenPosition.hlsl: cameras of any kind taken back to the world, and normals from depths alone.
#include <algorithm>
#include <glm/geometric.hpp>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"
#include "ShaderLibrary/random_camera.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr int kRow = 16 + 3 + 3;  // matrix by rows, (u, v, depth), and three more numbers
constexpr float kWidth = 1920.0f;
constexpr float kHeight = 1080.0f;
constexpr float kNoDepthSlope = 2.0f;

const std::string kPoint =
    "const float4x4 m = InMatrix(0); const float2 pixel = float2(1.0 / 1920.0, 1.0 / 1080.0); const "
    "ScreenPoint at = ScreenPointOf(m, In2(16), In(18));";

// Depths at which something is seen: between 1/1000 and all of the way from far to near.
std::vector<float> random_points(std::uint32_t seed) {
  Random random(seed);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    const RandomCamera camera = random_camera(random);
    inputs.insert(inputs.end(), camera.rows.begin(), camera.rows.end());
    inputs.insert(inputs.end(), {random.between(0.0f, 1.0f), random.between(0.0f, 1.0f),
                                 random.between(0.002f, 0.9f), random.between(-0.01f, 0.01f),
                                 random.between(-0.01f, 0.01f), random.between(-0.001f, 0.001f)});
  }
  return inputs;
}

struct ExactPoint {
  Vector position;
  long double w;
  Vector size;  // sum of each coordinate's terms without their signs
};

ExactPoint exact_point(const float* in, long double u, long double v, long double depth) {
  long double h[4];
  long double terms[4];
  for (int row = 0; row < 4; ++row) {
    const float* m = in + 4 * row;
    h[row] = m[0] * u + m[1] * v + m[2] * depth + m[3];
    terms[row] = std::fabs(m[0] * u) + std::fabs(m[1] * v) + std::fabs(m[2] * depth) + std::fabs(m[3]);
  }
  const long double w = std::fabs(h[3]);
  const long double worse = terms[3] / w;  // ratio by which the terms of w cancel
  return {Vector(h[0], h[1], h[2]) / h[3], h[3], Vector(terms[0], terms[1], terms[2]) / w * worse};
}

TEST(ScreenPosition, IsTheMatrixApplied) {
  expect_exact(
      {"ScreenPosition", kPoint + "Out3(0, at.positionWS.xyz);", kRow, 3}, random_points(61),
      [](const float* in) {
        const ExactPoint exact = exact_point(in, in[16], in[17], in[18]);
        std::vector<Exact> result;
        for (int k = 0; k < 3; ++k) result.push_back({exact.position[k], exact.size[k]});
        return result;
      },
      6.0L);
}

// The derivative is compared with a central difference in long double over a step a million times smaller.
TEST(ScreenPosition, TangentsAreDerivativesOfThePosition) {
  expect_exact(
      {"ScreenPosition", kPoint + "Out3(0, ScreenTangent(m, at, In3(19)));", kRow, 3}, random_points(62),
      [](const float* in) {
        const long double h = 1e-6L;
        const Vector step(in[19], in[20], in[21]);
        const ExactPoint at = exact_point(in, in[16], in[17], in[18]);
        const Vector after =
            exact_point(in, in[16] + h * step.x, in[17] + h * step.y, in[18] + h * step.z).position;
        const Vector before =
            exact_point(in, in[16] - h * step.x, in[17] - h * step.y, in[18] - h * step.z).position;
        std::vector<Exact> result;
        for (int k = 0; k < 3; ++k) {
          // Position errors come in times the step of w.
          long double scale = std::fabs((after[k] - before[k]) / (2.0L * h));
          const float* m = in + 4 * k;
          scale += (std::fabs(m[0] * step.x) + std::fabs(m[1] * step.y) + std::fabs(m[2] * step.z)) /
                   std::fabs(at.w);
          scale += at.size[k] * std::fabs(in[14] * step.z / at.w);
          result.push_back({(after[k] - before[k]) / (2.0L * h), scale});
        }
        return result;
      },
      8.0L);
}

TEST(ScreenPosition, PixelWidthIsTheSmallerSideInThePlaneOfEqualDepth) {
  expect_exact(
      {"ScreenPosition", kPoint + "Out(0, MetresPerPixel(m, at, pixel));", kRow, 1}, random_points(63),
      [](const float* in) {
        const Vector at = exact_point(in, in[16], in[17], in[18]).position;
        const Vector right = exact_point(in, in[16] + 1.0L / kWidth, in[17], in[18]).position;
        const Vector down = exact_point(in, in[16], in[17] + 1.0L / kHeight, in[18]).position;
        return std::vector<Exact>{{std::min(glm::length(right - at), glm::length(down - at))}};
      },
      // w cancels by up to three digits near the far plane, with one ULP at either end.
      4096.0L);
}

TEST(ScreenPosition, NormalsAreThoseOfThePlaneThatMadeTheDepths) {
  Random random(64);
  std::vector<float> inputs;
  std::vector<Vector> normals;
  while (normals.size() < std::size_t(kRandomCases)) {
    const RandomCamera camera = random_camera(random);
    const float u = random.between(0.1f, 0.9f);
    const float v = random.between(0.1f, 0.9f);
    const float depth = random.between(0.05f, 0.9f);
    const float slope_x = random.magnitude(-6.0f, -2.0f);
    const float slope_y = random.magnitude(-6.0f, -2.0f);
    const ExactPoint at = exact_point(camera.rows.data(), u, v, depth);
    const ExactPoint right = exact_point(camera.rows.data(), u + 1.0L / kWidth, v, depth + slope_x);
    const ExactPoint down = exact_point(camera.rows.data(), u, v + 1.0L / kHeight, depth + slope_y);
    if (!(at.w * right.w > 0.0L && at.w * down.w > 0.0L)) continue;  // the neighbour lies beyond infinity
    const Vector x = glm::normalize(right.position - at.position);
    const Vector y = glm::normalize(down.position - at.position);
    const Vector across = glm::cross(x, y);
    if (glm::length(across) < 0.01L) continue;  // the surface is edge-on, and rounding decides
    inputs.insert(inputs.end(), camera.rows.begin(), camera.rows.end());
    inputs.insert(inputs.end(), {u, v, depth, slope_x, slope_y, 0.0f});
    normals.push_back(glm::normalize(across));
  }
  const std::vector<float> results =
      run({"ScreenPosition", kPoint + "Out3(0, ScreenNormal(m, at, In2(19), pixel));", kRow, 3}, inputs);
  long double worst = 0.0L;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vector got(results[3 * i], results[3 * i + 1], results[3 * i + 2]);
    ASSERT_NEAR(double(glm::length(got)), 1.0, 1e-6);
    worst = std::max(worst, glm::length(got - normals[i]));
  }
  EXPECT_LE(worst, 0.01L);  // positions at 100 m are good to 1e-5 m, a step may be a millimetre
}

TEST(ScreenPosition, NormalsOfWhatMakesNoSenseAreZeroOrUnit) {
  std::vector<float> inputs;
  Random random(65);
  const std::vector<float> special = special_floats();
  for (int i = 0; i < kRandomCases; ++i) {
    for (int k = 0; k < kRow; ++k) {
      inputs.push_back(special[std::size_t(random.integer(0, int(special.size()) - 1))]);
    }
  }
  const std::vector<float> results =
      run({"ScreenPosition",
           kPoint + "const float3 n = ScreenNormal(m, at, In2(19), pixel); Out(0, dot(n, n));", kRow, 1},
          inputs);
  for (const float squared : results)
    ASSERT_TRUE(squared == 0.0f || std::abs(squared - 1.0f) < 1e-5f) << squared;
  // The slope is not known here.
  std::vector<float> unknown = random_points(66);
  for (std::size_t i = 0; i < unknown.size(); i += kRow) unknown[i + 19 + (i / kRow) % 2] = 2.0f;
  for (const float squared :
       run({"ScreenPosition",
            kPoint + "const float3 n = ScreenNormal(m, at, In2(19), pixel); Out(0, dot(n, n));", kRow, 1},
           unknown)) {
    ASSERT_EQ(squared, 0.0f);
  }
}

bool is_surface(float depth) {
  return depth > 0.0f && depth < 1.0f;  // false for NaN
}

TEST(ScreenPosition, NeitherSkyNorNearPlaneNorNanIsASurface) {
  const std::vector<float> inputs = special_floats();
  const std::vector<float> results =
      run({"ScreenPosition", "Out(0, IsSurfaceDepth(In(0)) ? 1.0 : 0.0);", 1, 1}, inputs);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    // Numbers too small for a normal float may be 0 to the device.
    if (std::fpclassify(inputs[i]) == FP_SUBNORMAL) continue;
    EXPECT_EQ(results[i] != 0.0f, is_surface(inputs[i])) << inputs[i];
  }
}

// The lines are five depths in a row: planes, edges, sky beside them, and rubbish.
std::vector<float> random_lines(std::uint32_t seed) {
  Random random(seed);
  const std::vector<float> special = special_floats();
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    const float slope = random.magnitude(-5.0f, -2.0f);
    const float here = random.between(0.1f, 0.9f);
    for (int k = -2; k <= 2; ++k) {
      float depth = here + float(k) * slope;
      if (k != 0 && random.integer(0, 3) == 0) depth = random.between(-0.2f, 1.2f);
      if (k != 0 && random.integer(0, 9) == 0)
        depth = special[std::size_t(random.integer(0, int(special.size()) - 1))];
      inputs.push_back(depth);
    }
  }
  return inputs;
}

TEST(ScreenPosition, SlopesFollowTheSurfaceThatGoesOn) {
  const std::vector<float> inputs = random_lines(67);
  const std::vector<float> results =
      run({"ScreenPosition",
           "DepthLine along; along.before = In(1); along.here = In(2); along.after = In(3); Out(0, "
           "DepthSlopes(along).x); Out(1, DepthSlopes(along).y); Out(2, NearerSlope(along)); Out(3, "
           "ContradictsItself(along) ? 1.0 : 0.0); Out(4, StraighterSlope(In(0), along, In(4)));",
           5, 5},
          inputs);
  int contradictions = 0;
  for (std::size_t i = 0; i < inputs.size() / 5; ++i) {
    const float* in = &inputs[5 * i];
    const float* got = &results[5 * i];
    const float before = is_surface(in[1]) ? in[2] - in[1] : kNoDepthSlope;
    const float after = is_surface(in[3]) ? in[3] - in[2] : kNoDepthSlope;
    ASSERT_EQ(got[0], before);
    ASSERT_EQ(got[1], after);
    const float nearer = std::abs(after) < std::abs(before) ? after : before;
    ASSERT_EQ(got[2], nearer);
    const bool contradicts = is_surface(in[1]) && is_surface(in[3]) &&
                             std::abs(before - after) > std::max(std::abs(before), std::abs(after)) / 16.0f;
    ASSERT_EQ(got[3] != 0.0f, contradicts);
    contradictions += contradicts ? 1 : 0;
    if (!contradicts) continue;
    const float unknown = 0.5f * std::abs(before - after);
    const float bend_before = is_surface(in[0]) ? std::abs(in[1] - in[0] - before) : unknown;
    const float bend_after = is_surface(in[4]) ? std::abs(in[4] - in[3] - after) : unknown;
    ASSERT_EQ(got[4], bend_before == bend_after ? nearer : bend_before < bend_after ? before : after);
  }
  EXPECT_GT(contradictions, kRandomCases / 10);
}

TEST(ScreenPosition, PlaneWeightFallsFromOneToZeroBesideThePlane) {
  std::vector<float> inputs = random_cases(68, [&](Random& random) {
    return Case{random.between(-3.0f, 3.0f), random.between(0.01f, 2.0f)};
  });
  for (const float beside : special_floats()) inputs.insert(inputs.end(), {beside, 1.0f});
  for (const float tolerance : special_floats()) inputs.insert(inputs.end(), {0.5f, tolerance});
  const std::vector<float> results =
      run({"ScreenPosition", "Out(0, PlaneWeight(float3(7.0, In(0), -3.0), float3(0.0, 1.0, 0.0), In(1)));",
           2, 1},
          inputs);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const double beside = std::abs(inputs[2 * i]);
    const double tolerance = inputs[2 * i + 1];
    const double expected = beside < tolerance ? 1.0 - beside / tolerance : 0.0;
    ASSERT_NEAR(results[i], expected, 1e-6) << inputs[2 * i] << " of " << inputs[2 * i + 1];
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
