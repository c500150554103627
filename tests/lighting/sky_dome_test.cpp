#include "lighting/sky_dome.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

namespace penumbra::lighting {
namespace {

glm::dvec3 some_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

TEST(SkyDome, AUniformOneIsUniformAndItsIrradianceIsPi) {
  const SkyDome dome([](const glm::dvec3&) { return glm::dvec3(1.0, 2.0, 3.0); });
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 direction(some_direction(random));
    ASSERT_LT(glm::distance(dome.radiance(direction), glm::vec3(1, 2, 3)), 1e-5F);
    ASSERT_LT(glm::distance(dome.irradiance(direction), glm::vec3(1, 2, 3) * std::numbers::pi_v<float>),
              1e-3F);
  }
}

TEST(SkyDome, ASmoothOneIsWhatWasTabulated) {
  const auto light = [](const glm::dvec3& d) {
    return glm::dvec3(1.0 + d.x, 1.0 + d.y * d.y, 1.0 + d.x * d.z);
  };
  const SkyDome dome(light);
  std::mt19937 random(2);
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 direction = some_direction(random);
    ASSERT_LT(glm::distance(glm::dvec3(dome.radiance(glm::vec3(direction))), light(direction)), 0.03)
        << direction.x << " " << direction.y << " " << direction.z;
  }
}

// Under a sky of radiance 1 + y, level ground receives pi + 2 pi / 3, and a wall pi.
TEST(SkyDome, IrradianceIsTheClosedForm) {
  const SkyDome dome([](const glm::dvec3& d) { return glm::dvec3(1.0 + d.y); });
  constexpr float kPi = std::numbers::pi_v<float>;
  EXPECT_NEAR(dome.irradiance({0, 1, 0}).r, kPi + 2.0F * kPi / 3.0F, 1e-3F);
  EXPECT_NEAR(dome.irradiance({1, 0, 0}).r, kPi, 1e-3F);
  EXPECT_NEAR(dome.irradiance({0, -1, 0}).r, kPi / 3.0F, 1e-3F);
}

}  // namespace
}  // namespace penumbra::lighting
