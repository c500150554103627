#include "lighting/shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

namespace penumbra::lighting {
namespace {

constexpr double kPi = std::numbers::pi;

SurfacePoint matt(const glm::vec3& colour) {
  SurfacePoint point;
  point.flat_normal = point.normal = {0.0F, 1.0F, 0.0F};
  point.base_colour = colour;
  point.roughness = 1.0F;
  return point;
}

// The sum of the published terms, in double, for one point and a pair of directions.
glm::dvec3 by_hand(const SurfacePoint& point, const glm::dvec3& v, const glm::dvec3& l,
                   const glm::dvec3& sun) {
  const glm::dvec3 n(point.normal);
  const glm::dvec3 h = glm::normalize(v + l);
  const double nl = glm::dot(n, l);
  const double nv = glm::dot(n, v);
  const double nh = glm::dot(n, h);
  const auto fresnel = [](double cosine) { return 0.04 + 0.96 * std::pow(1.0 - cosine, 5.0); };
  const double a2 = std::pow(point.roughness, 4.0);
  const double d = a2 / (kPi * std::pow(nh * nh * (a2 - 1.0) + 1.0, 2.0));
  const auto lambda = [&](double cosine) {
    return (std::sqrt(1.0 + a2 * (1.0 / (cosine * cosine) - 1.0)) - 1.0) / 2.0;
  };
  const double g = 1.0 / (1.0 + lambda(nl) + lambda(nv));
  const glm::dvec3 matt_part =
      glm::dvec3(point.base_colour) * ((1.0 - point.translucency) * (1.0 - fresnel(nl)) / kPi);
  const double t = std::min(
      1.0, glm::dot(glm::dvec3(point.flat_normal), l) / (nl * glm::dot(glm::dvec3(point.flat_normal), n)));
  return (matt_part + d * g * fresnel(glm::dot(h, l)) / (4.0 * nl * nv)) * sun * nl *
         (-t * t * t + t * t + t);
}

TEST(Shading, IsThePublishedSumOfTerms) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int compared = 0;
  while (compared < 300) {
    SurfacePoint point = matt({0.7F, 0.3F, 0.1F});
    point.roughness = static_cast<float>(0.55 + 0.45 * any(random));
    point.translucency = static_cast<float>(0.2 + 0.2 * any(random));
    point.normal = glm::normalize(glm::vec3(0.3 * any(random), 1.0, 0.3 * any(random)));
    const glm::dvec3 v = glm::normalize(glm::dvec3(any(random), 1.05 + any(random), any(random)));
    const glm::dvec3 l = glm::normalize(glm::dvec3(any(random), 1.05 + any(random), any(random)));
    if (glm::dot(glm::dvec3(point.normal), v) < 0.05 || glm::dot(glm::dvec3(point.normal), l) < 0.05)
      continue;
    if (point.roughness < 0.15F) continue;
    const glm::dvec3 expected = by_hand(point, v, l, {3.0, 2.0, 1.0});
    const glm::vec3 shaded = lit_by_sun(point, glm::vec3(v), {glm::vec3(l), {3.0F, 2.0F, 1.0F}});
    ASSERT_LT(glm::length(glm::dvec3(shaded) - expected), 2e-3 * glm::length(expected));
    ++compared;
  }
}

TEST(Shading, AMattSurfaceReflectsNoMoreThanItsColour) {
  // The albedo in the sun is the radiance towards all directions, by cosine, over what arrives.
  for (const float roughness : {0.3F, 0.6F, 1.0F}) {
    SurfacePoint point = matt(glm::vec3(1.0F));
    point.roughness = roughness;
    for (const double elevation : {15.0, 45.0, 80.0}) {
      const double e = elevation * kPi / 180.0;
      const Sunlight sun{{std::cos(e), std::sin(e), 0.0}, glm::vec3(1.0F)};
      double sum = 0.0;
      constexpr int kSteps = 128;
      for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
          const double sine = std::sqrt((i + 0.5) / kSteps);
          const double angle = 2.0 * kPi * (j + 0.5) / kSteps;
          const glm::vec3 view(sine * std::cos(angle), std::sqrt(1.0 - sine * sine), sine * std::sin(angle));
          sum += lit_by_sun(point, view, sun).g;
        }
      }
      const double albedo = sum * kPi / (kSteps * kSteps) / std::sin(e);
      EXPECT_LT(albedo, 1.01) << roughness << " " << elevation;
      EXPECT_GT(albedo, 0.7) << roughness << " " << elevation;
    }
  }
}

TEST(Shading, FacesTurnedFromTheSunHaveNoSunAndPassOnWhatComesThrough) {
  SurfacePoint leaf = matt({0.2F, 0.5F, 0.1F});
  leaf.translucency = 0.4F;
  const Sunlight behind{{0.0F, -1.0F, 0.0F}, glm::vec3(10.0F)};
  EXPECT_EQ(lit_by_sun(leaf, {0, 1, 0}, behind), glm::vec3(0.0F));
  EXPECT_NEAR(lit_through(leaf, behind).g, 0.5 * 0.4 * 10.0 / kPi, 1e-5);
  const Sunlight above{{0.0F, 1.0F, 0.0F}, glm::vec3(10.0F)};
  EXPECT_EQ(lit_through(leaf, above), glm::vec3(0.0F));
  leaf.translucency = 0.0F;
  EXPECT_EQ(lit_through(leaf, behind), glm::vec3(0.0F));
}

// A bent normal still sees the sun where the triangle does not: the light does not end at a step, but fades
// to nothing.
TEST(Shading, FadesOutWhereTheTriangleTurnsAway) {
  SurfacePoint point = matt(glm::vec3(0.5F));
  point.normal = glm::normalize(glm::vec3(0.5F, 1.0F, 0.0F));
  float last = 1e9F;
  for (int i = 100; i >= -5; --i) {
    const float y = float(i) / 200.0F;
    const Sunlight sun{glm::normalize(glm::vec3(1.0F, y, 0.0F)), glm::vec3(1.0F)};
    const float light = lit_by_sun(point, {0, 1, 0}, sun).g;
    EXPECT_LE(light, last);
    if (i <= 0) {
      EXPECT_EQ(light, 0.0F);
    }
    if (i == 1) {
      EXPECT_LT(light, 0.01F);
    }
    last = light;
  }
}

TEST(Shading, SkyLightOfOneLeavesAMattSurfaceItsColour) {
  const SurfacePoint point = matt({0.8F, 0.4F, 0.0F});
  const glm::vec3 shaded = lit_by_sky(point, {0, 1, 0}, glm::vec3(1.0F));
  EXPECT_NEAR(shaded.r, 0.8F, 0.02F);
  EXPECT_NEAR(shaded.g, 0.4F, 0.02F);
  EXPECT_GT(shaded.b, 0.0F) << "the gloss";
  for (const float roughness : {0.0F, 0.3F, 1.0F}) {
    for (const float up : {0.0F, 0.1F, 0.5F, 1.0F}) {
      SurfacePoint white = matt(glm::vec3(1.0F));
      white.roughness = roughness;
      const glm::vec3 view = glm::normalize(glm::vec3(1.0F - up, up, 0.0F));
      EXPECT_NEAR(lit_by_sky(white, view, glm::vec3(1.0F)).g, 1.0F, 1e-5F) << "a white furnace";
    }
  }
}

}  // namespace
}  // namespace penumbra::lighting
