// Compares the reference's shade of clouds with a sum over another set of points of the disc.
#include "reference/trace_visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "reference/lit_receiver.h"

namespace penumbra::reference {
namespace {

struct Made {
  VisibilityImage image;
  scene::Receivers receivers;
  scene::Scene scene;
};

// A row of places on level ground, one of them above the clouds.
Made made() {
  constexpr int kPlaces = 24;
  Made all;
  all.image = {kPlaces, 1, std::vector<float>(kPlaces, 0.5F), std::vector<std::uint8_t>(kPlaces, 1), 0.0, 64};
  all.receivers.width = kPlaces;
  all.receivers.height = 1;
  for (int i = 0; i < kPlaces; ++i)
    all.receivers.position_relative.emplace_back(400.0F * static_cast<float>(i), i == 5 ? 2000.0F : 10.0F,
                                                 70.0F, 1.0F);
  all.image.valid[7] = 0;
  all.scene.origin = {100.0, 20.0, -300.0};
  all.scene.clouds = scene::CloudLayer{};
  return all;
}

double shade_by_rings(const Made& all, const DiscLight& light, std::size_t place) {
  const glm::dvec3 from = all.scene.origin + glm::dvec3(all.receivers.position_relative[place]);
  double sum = 0.0;
  constexpr int kRings = 24, kSpokes = 48;
  for (int ring = 0; ring < kRings; ++ring)
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double radius = light.tan_half * std::sqrt((ring + 0.5) / kRings);
      const double angle = 2.0 * std::acos(-1.0) * spoke / kSpokes;
      const glm::dvec3 way = glm::normalize(light.to_light + radius * std::cos(angle) * light.right +
                                            radius * std::sin(angle) * light.up);
      const glm::dvec3 at = from + way * ((all.scene.clouds->altitude_metres - from.y) / way.y);
      sum += std::pow(scene::cloud_transmittance(*all.scene.clouds, {at.x, at.z}), 1.0 / way.y);
    }
  return sum / (kRings * kSpokes);
}

TEST(CloudShadow, IsTheMeanOverTheDiscOfWhatPassesTheLayer) {
  const parameters::Light light{{0.5, -0.6, 0.2}, 2.0};
  Made all = made();
  const Made before = all;
  shade_by_clouds(all.image, all.scene, all.receivers, light);
  int shaded = 0;
  for (std::size_t i = 0; i < all.image.visibility.size(); ++i) {
    const double wanted = i == 7 || i == 5 ? 0.5 : 0.5 * shade_by_rings(before, disc_light(light), i);
    EXPECT_NEAR(all.image.visibility[i], wanted, 0.003) << i;
    shaded += wanted < 0.45 ? 1 : 0;
  }
  EXPECT_GT(shaded, 5);
  EXPECT_EQ(all.image.visibility[5], 0.5F) << "over the clouds";
  EXPECT_EQ(all.image.visibility[7], 0.5F) << "no receiver";
}

TEST(CloudShadow, IsNoneWithoutClouds) {
  const parameters::Light light{{0.5, -0.6, 0.2}, 2.0};
  for (const bool layer : {true, false}) {
    Made all = made();
    if (layer)
      all.scene.clouds->coverage = 0.0;
    else
      all.scene.clouds.reset();
    shade_by_clouds(all.image, all.scene, all.receivers, light);
    for (const float visibility : all.image.visibility) EXPECT_EQ(visibility, 0.5F);
  }
}

}  // namespace
}  // namespace penumbra::reference
