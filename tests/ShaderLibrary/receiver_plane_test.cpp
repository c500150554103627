// Core/ReceiverPlane.hlsl: the receiver's plane in the shadow map, from derivatives and from the normal.
#include <algorithm>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"
#include "ShaderLibrary/long_vectors.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr long double kLargestGradient = 1024.0L;
constexpr const char* kFromDerivatives = "Out2(0, ReceiverPlaneFromDerivatives(In3(0), In3(3)));";
constexpr const char* kFromNormal =
    "const float4x4 m = float4x4(In(3), In(4), In(5), 0, In(6), In(7), In(8), 0, In(9), In(10), In(11), 0, "
    "0, 0, 0, 1); Out2(0, ReceiverPlaneFromNormal(In3(0), m));";

// The determinant cancels: its relative error is the ratio of its terms to itself, and the whole result has
// it. The scale is the sum of the terms over the determinant, times that ratio.
std::vector<Exact> exact_from_derivatives(const float* in) {
  const long double ux = in[0], vx = in[1], zx = in[2], uy = in[3], vy = in[4], zy = in[5];
  const long double determinant = ux * vy - vx * uy;
  const long double terms = std::fabs(ux * vy) + std::fabs(vx * uy);
  const long double worse = terms / std::fabs(determinant) / std::fabs(determinant);
  return {{(vy * zx - vx * zy) / determinant, (std::fabs(vy * zx) + std::fabs(vx * zy)) * worse},
          {(ux * zy - uy * zx) / determinant, (std::fabs(ux * zy) + std::fabs(uy * zx)) * worse}};
}

// The screen derivatives are those of a plane under pixels of any size from 1e-12 to 1 of the atlas, at
// angles from 0.2 degrees.
TEST(ReceiverPlane, FromDerivativesInvertsTheJacobian) {
  Random random(10);
  std::vector<float> inputs;
  while (inputs.size() < 6 * std::size_t(kRandomCases)) {
    const float size = std::pow(10.0f, random.between(-12.0f, 0.0f));
    const float angle = random.between(0.0f, 6.2831f);
    const float between = random.between(0.004f, 3.13f);
    const float slope_u = random.between(-50.0f, 50.0f);
    const float slope_v = random.between(-50.0f, 50.0f);
    const float stretch = std::pow(10.0f, random.between(-2.0f, 2.0f));
    const float ux = size * std::cos(angle), vx = size * std::sin(angle);
    const float uy = stretch * size * std::cos(angle + between),
                vy = stretch * size * std::sin(angle + between);
    inputs.insert(inputs.end(), {ux, vx, slope_u * ux + slope_v * vx, uy, vy, slope_u * uy + slope_v * vy});
  }
  // Scaling to unit length rounds each entry once, products round once more, and the determinant and the
  // quotient again (a division may be off by 2.5 ULP in Vulkan). The sum is 12 ULP of the terms.
  expect_exact({"ReceiverPlane", kFromDerivatives, 6, 2}, inputs, exact_from_derivatives, 12.0L);
}

TEST(ReceiverPlane, DegenerateDerivativesKnowNoPlane) {
  const std::vector<float> inputs = random_cases(11, [&](Random& random, int i) {
    const float u = random.magnitude(-6.0f, 0.0f), v = random.magnitude(-6.0f, 0.0f);
    // The second derivative is parallel to the first, or has no length at all.
    const float factor = i % 3 == 0 ? 0.0f : random.magnitude(-3.0f, 3.0f);
    return Case{u, v, random.between(-1.0f, 1.0f), factor * u, factor * v, random.between(-1.0f, 1.0f)};
  });
  expect_within({"ReceiverPlane", kFromDerivatives, 6, 2}, inputs, 0.0f, 0.0f);
}

// The light's matrix is orthogonal and random: its rows across the light have one length, the row along it
// another.
std::vector<float> plane_and_light(Random& random, long double smallest_sine) {
  const auto direction = [&] {
    return unit(
        {random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f) + 1e-3L});
  };
  for (;;) {
    const Vector along = direction();
    const Vector across = unit(cross(along, direction()));
    const Vector up = cross(along, across);
    const Vector normal = direction();
    if (std::fabs(dot(normal, along)) < smallest_sine) continue;
    const long double uv = std::pow(10.0L, random.between(-3.0f, -1.0f));
    const long double depth = std::pow(10.0L, random.between(-4.0f, -2.0f));
    std::vector<float> in;
    for (const long double n : normal) in.push_back(static_cast<float>(n));
    for (const long double a : across) in.push_back(static_cast<float>(a * uv));
    for (const long double a : up) in.push_back(static_cast<float>(a * uv));
    for (const long double a : along) in.push_back(static_cast<float>(a * depth));
    return in;
  }
}

// The gradient comes from its own definition: depth and UV of two directions that lie in the plane, solved
// for the slopes.
std::vector<Exact> exact_from_normal(const float* in) {
  const Vector n{in[0], in[1], in[2]};
  const Vector rows[3] = {{in[3], in[4], in[5]}, {in[6], in[7], in[8]}, {in[9], in[10], in[11]}};
  const Vector other = std::fabs(n[0]) < 0.6L ? Vector{1.0L, 0.0L, 0.0L} : Vector{0.0L, 1.0L, 0.0L};
  const Vector s = unit(cross(n, other));
  const Vector t = unit(cross(n, s));
  const long double us = dot(rows[0], s), vs = dot(rows[1], s), zs = dot(rows[2], s);
  const long double ut = dot(rows[0], t), vt = dot(rows[1], t), zt = dot(rows[2], t);
  const long double determinant = us * vt - vs * ut;
  // The matrix given in float is orthogonal to 2^-24 only, which moves both gradients by that much of the
  // larger one and of the slope's scale |row2| / |row0| / sine^2.
  const long double sine = std::fabs(dot(n, rows[2])) / std::sqrt(dot(rows[2], rows[2]));
  const long double scale = std::sqrt(dot(rows[2], rows[2]) / dot(rows[0], rows[0])) / (sine * sine);
  return {{(vt * zs - vs * zt) / determinant, scale}, {(us * zt - ut * zs) / determinant, scale}};
}

// The roundings are three dot products (5 each at the size of their terms), three quotients, and the inputs'
// own.
TEST(ReceiverPlane, FromNormalIsThePlanesSlope) {
  Random random(12);
  std::vector<float> inputs;
  while (inputs.size() < 12 * std::size_t(kRandomCases)) {
    const std::vector<float> in = plane_and_light(random, 0.01L);
    const std::vector<Exact> exact = exact_from_normal(in.data());
    if (std::max(std::fabs(exact[0].value), std::fabs(exact[1].value)) > 0.99L * kLargestGradient) continue;
    inputs.insert(inputs.end(), in.begin(), in.end());
  }
  expect_exact({"ReceiverPlane", kFromNormal, 12, 2}, inputs, exact_from_normal, 16.0L);
}

TEST(ReceiverPlane, GradientsAreFiniteAndBoundedForAnyInput) {
  Random random(13);
  std::vector<float> inputs(12 * std::size_t(kRandomCases));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    inputs[i] = i % 5 == 0 ? random.any_bits() : random.magnitude(-8.0f, 8.0f);
  }
  const std::string all = std::string("{ ") + kFromDerivatives + " } { " + kFromNormal +
                          " Out2(2, ReceiverPlaneFromNormal(In3(0), m)); } Out2(4, BoundGradient(In2(0))); "
                          "Out2(0, ReceiverPlaneFromDerivatives(In3(0), In3(3)));";
  expect_within({"ReceiverPlane", all, 12, 6}, inputs, -1024.001f, 1024.001f);
}

TEST(ReceiverPlane, BoundGradientKeepsDirectionAndSmallGradients) {
  Random random(14);
  std::vector<float> inputs;
  inputs.reserve(2 * std::size_t(kRandomCases));
  for (int i = 0; i < 2 * kRandomCases; ++i) inputs.push_back(random.magnitude(-3.0f, 8.0f));
  // The result is a quotient (2.5 ULP) and a product.
  expect_exact(
      {"ReceiverPlane", "Out2(0, BoundGradient(In2(0)));", 2, 2}, inputs,
      [](const float* in) {
        const long double steepest = std::max(std::fabs(in[0]), std::fabs(in[1]));
        const long double factor = std::min(1.0L, kLargestGradient / steepest);
        return std::vector<Exact>{{in[0] * factor}, {in[1] * factor}};
      },
      4.0L);
}

// The depth has two products and two sums; fused operations round less.
TEST(ReceiverPlane, DepthOnThePlaneStaysInTheMap) {
  const std::vector<float> inputs = random_cases(15, [&](Random& random) {
    return Case{random.between(0.0f, 1.0f), random.between(-50.0f, 50.0f), random.between(-50.0f, 50.0f),
                random.between(-0.02f, 0.02f), random.between(-0.02f, 0.02f)};
  });
  expect_exact(
      {"ReceiverPlane", "Out(0, ReceiverPlaneDepth(In(0), In2(1), In2(3)));", 5, 1}, inputs,
      [](const float* in) {
        const long double a = static_cast<long double>(in[1]) * in[3];
        const long double b = static_cast<long double>(in[2]) * in[4];
        return std::vector<Exact>{
            {std::clamp(in[0] + a + b, 0.0L, 1.0L), in[0] + std::fabs(a) + std::fabs(b)}};
      },
      2.5L);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
