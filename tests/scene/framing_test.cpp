// Tests the camera of an imported model: the model and its shadow fill the picture, whatever their size.
#include "scene/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/scene.h"

namespace penumbra::scene {
namespace {

// The picture coordinates, with the edges at -1 and 1.
glm::dvec2 projected(const parameters::Camera& camera, const glm::dvec3& point) {
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, camera.forward));
  const glm::dvec3 up = glm::cross(camera.forward, right);
  const glm::dvec3 to = point - camera.position;
  const double tan_half = std::tan(0.5 * glm::radians(camera.fov_y_degrees));
  return {glm::dot(to, right) / (glm::dot(to, camera.forward) * tan_half * camera.aspect),
          glm::dot(to, up) / (glm::dot(to, camera.forward) * tan_half)};
}

// The corners of the box, and where the light carries those of its top.
std::vector<glm::dvec3> model_and_shadow(const parameters::Bounds& box, const glm::dvec3& light) {
  std::vector<glm::dvec3> points;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 point{corner & 1 ? box.maximum.x : box.minimum.x,
                           corner & 2 ? box.maximum.y : box.minimum.y,
                           corner & 4 ? box.maximum.z : box.minimum.z};
    points.push_back(point);
    points.push_back(point - light * ((point.y - box.minimum.y) / light.y));
  }
  return points;
}

class Framing : public testing::TestWithParam<glm::dvec3> {};

TEST_P(Framing, ModelAndShadowFillThePictureAndNothingIsCut) {
  const glm::dvec3 size = GetParam();
  const parameters::Bounds box{{-0.5 * size.x, 0.0, -0.5 * size.z}, {0.5 * size.x, size.y, 0.5 * size.z}};
  const glm::dvec3 light = sunlight(45.0, 50.0);
  const parameters::Camera camera = framing_camera(box, light);
  double largest = 0.0;
  double nearest = 1e9;
  double farthest = 0.0;
  for (const glm::dvec3& point : model_and_shadow(box, light)) {
    const glm::dvec2 at = projected(camera, point);
    largest = std::max({largest, std::abs(at.x), std::abs(at.y)});
    nearest = std::min(nearest, glm::dot(point - camera.position, camera.forward));
    farthest = std::max(farthest, glm::distance(point, camera.position));
  }
  EXPECT_LE(largest, 0.93);
  EXPECT_GE(largest, 0.91);
  EXPECT_LT(camera.near_plane, nearest);
  EXPECT_NEAR(framed_reach(camera, box, light), farthest, 1e-6 * farthest);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Framing,
                         testing::Values(glm::dvec3(2.0, 2.0, 1.0), glm::dvec3(0.05, 0.08, 0.05),
                                         glm::dvec3(40.0, 25.0, 30.0), glm::dvec3(10.0, 0.5, 10.0),
                                         glm::dvec3(0.3, 12.0, 0.3)));

}  // namespace
}  // namespace penumbra::scene
