// Core/ScreenRay.hlsl: points of rays, against the same points projected by the inverse matrix.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"
#include "ShaderLibrary/random_camera.h"

namespace penumbra::shader_library_tests {
namespace {

using Matrix = glm::mat<4, 4, long double>;

constexpr int kRayRow = 16 + 3 + 3 + 1;  // matrix by rows, (u, v, depth), direction, metres

const std::string kRay =
    "const float4x4 m = InMatrix(0); const float3 origin = In3(16); const ScreenRay ray = ScreenRayOf(m, "
    "ScreenPointOf(m, origin.xy, origin.z), origin, In3(19));";

Matrix matrix_of(const std::array<long double, 16>& rows) {
  Matrix matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix[column][row] = rows[std::size_t(4 * row + column)];
  return matrix;
}

// The end of a ray from (u, v, depth), and how much its depth along the view has grown there.
struct Projected {
  Vector point;
  long double growth;
};

Projected projected(const std::array<long double, 16>& rows, const Vector& origin, const Vector& direction,
                    long double metres) {
  const Matrix matrix = matrix_of(rows);
  const glm::vec<4, long double> from = matrix * glm::vec<4, long double>(origin, 1.0L);
  const Vector world = Vector(from) / from.w + direction * metres;
  const glm::vec<4, long double> seen = glm::inverse(matrix) * glm::vec<4, long double>(world, 1.0L);
  return {Vector(seen) / seen.w, seen.w * from.w};
}

std::array<long double, 16> rows_of(const float* in) {
  std::array<long double, 16> rows;
  std::copy(in, in + 16, rows.begin());
  return rows;
}

Projected end_of(const float* in) {
  return projected(rows_of(in), {in[16], in[17], in[18]}, {in[19], in[20], in[21]}, in[22]);
}

Vector seen_by(const std::array<long double, 16>& rows, const Vector& world) {
  const glm::vec<4, long double> h = glm::inverse(matrix_of(rows)) * glm::vec<4, long double>(world, 1.0L);
  return Vector(h) / h.w;
}

// The change of the way over the screen, times the rounding of every entry of the matrix, and of the position
// that its tangents are taken at, which is not where they would be exact.
Vector sensitivity(const float* in) {
  constexpr long double kStep = 1e-7L;
  const std::array<long double, 16> rows = rows_of(in);
  const glm::vec<4, long double> from =
      matrix_of(rows) * glm::vec<4, long double>(in[16], in[17], in[18], 1.0L);
  const Vector begin = Vector(from) / from.w;
  const Vector end = begin + Vector(in[19], in[20], in[21]) * static_cast<long double>(in[22]);
  const Vector way = seen_by(rows, end) - seen_by(rows, begin);
  Vector sum(std::fabs(in[16]), std::fabs(in[17]), std::fabs(in[18]));
  sum += glm::abs(way);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::array<long double, 16> moved = rows;
    const long double size =
        std::fabs(rows[k]) + (k < 12 ? std::fabs(begin[int(k / 4)] * rows[12 + k % 4]) : 0.0L);
    moved[k] += kStep * size;
    sum += glm::abs(seen_by(moved, end) - seen_by(moved, begin) - way) / kStep;
  }
  return sum;
}

std::vector<float> random_rays(std::uint32_t seed) {
  Random random(seed);
  std::vector<float> inputs;
  while (inputs.size() < std::size_t(kRandomCases) * kRayRow) {
    const RandomCamera camera = random_camera(random);
    std::vector<float> row(camera.rows.begin(), camera.rows.end());
    for (const float number :
         {random.between(0.0f, 1.0f), random.between(0.0f, 1.0f), random.between(0.002f, 0.9f)})
      row.push_back(number);
    const Vector direction = glm::normalize(
        Vector(random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f)));
    for (int k = 0; k < 3; ++k) row.push_back(float(direction[k]));
    row.push_back(std::pow(10.0f, random.between(-3.0f, 1.0f)));
    const long double growth = end_of(row.data()).growth;
    if (!(growth > 0.1L && growth < 10.0L)) continue;  // it ends behind the camera, or nearly
    inputs.insert(inputs.end(), row.begin(), row.end());
  }
  return inputs;
}

TEST(ScreenRay, PointsAreThoseOfTheWorldProjected) {
  expect_exact(
      {"ScreenRay", kRay + "Out3(0, ScreenRayPoint(ray, ScreenRayAlong(ray, In(22))));", kRayRow, 3},
      random_rays(71),
      [](const float* in) {
        const Vector exact = end_of(in).point;
        const Vector scale = sensitivity(in);
        std::vector<Exact> result;
        for (int k = 0; k < 3; ++k) result.push_back({exact[k], scale[k]});
        return result;
      },
      16.0L);
}

TEST(ScreenRay, LengthsComeBackAndARayBehindTheCameraHasNoEnd) {
  const std::vector<float> rays = random_rays(72);
  const std::vector<float> back = run(
      {"ScreenRay", kRay + "Out(0, ScreenRayMetres(ray, ScreenRayAlong(ray, In(22))));", kRayRow, 1}, rays);
  for (std::size_t i = 0; i < back.size(); ++i)
    ASSERT_NEAR(back[i], rays[i * kRayRow + 22], 2e-5 * rays[i * kRayRow + 22]) << i;
  // The inputs are bend and metres.
  const std::vector<float> inputs{-0.5f, 1.0f, -0.5f, 2.0f, -0.5f, 3.0f, 0.0f, 3.0f, 1.0f, 3.0f};
  const std::vector<float> along = run(
      {"ScreenRay", "ScreenRay ray; ray.bend = In(0); Out(0, ScreenRayAlong(ray, In(1)));", 2, 1}, inputs);
  EXPECT_FLOAT_EQ(along[0], 2.0f);
  EXPECT_GE(along[1], 1e6f);
  EXPECT_GE(along[2], 1e6f);
  EXPECT_FLOAT_EQ(along[3], 3.0f);
  EXPECT_FLOAT_EQ(along[4], 0.75f);
}

// The end is found by bisection over the points of the line.
TEST(ScreenRay, EndsAtTheBorderOfThePicture) {
  Random random(73);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    for (int k = 0; k < 3; ++k) inputs.push_back(random.between(0.01f, 0.99f));
    for (int k = 0; k < 3; ++k)
      inputs.push_back(random.integer(0, 9) == 0 ? 0.0f : random.magnitude(-3.0f, 1.0f));
    inputs.push_back(std::pow(10.0f, random.between(-2.0f, 3.0f)));
  }
  const std::vector<float> ends =
      run({"ScreenRay",
           "ScreenRay ray; ray.origin = In3(0); ray.slope = In3(3); ray.bend = 0.0; Out(0, "
           "ScreenRayWithin(ray, In(6))); Out(1, WithinUnit(In(0), In(3), In(6)));",
           7, 2},
          inputs);
  for (std::size_t i = 0; i < ends.size() / 2; ++i) {
    const float* in = &inputs[7 * i];
    const auto last_inside = [&](int coordinates) {
      long double low = 0.0L, high = in[6];
      const auto inside = [&](long double along) {
        for (int k = 0; k < coordinates; ++k) {
          const long double at = in[k] + in[3 + k] * along;
          if (at < 0.0L || at > 1.0L) return false;
        }
        return true;
      };
      if (inside(high)) return high;
      for (int step = 0; step < 80; ++step) (inside(0.5L * (low + high)) ? low : high) = 0.5L * (low + high);
      return low;
    };
    ASSERT_NEAR(ends[2 * i], double(last_inside(3)), 1e-6 * double(last_inside(3))) << i;
    ASSERT_NEAR(ends[2 * i + 1], double(last_inside(1)), 1e-6 * double(last_inside(1))) << i;
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
