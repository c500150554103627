// Goes from a pixel to the world and back by the way a GPU gets there.
#include "parameters/screen_to_world.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "parameters/golden_cameras.h"

namespace penumbra::parameters {
namespace {

using Vec4 = glm::vec<4, long double>;
using Mat4 = glm::mat<4, 4, long double>;

// The (u, v, stored depth) of a world position.
glm::dvec3 stored(const GoldenCamera& camera, const Vec4& world) {
  const Vec4 clip = Mat4(camera.gpu_projection) * (Mat4(camera.view) * world);
  const Vec4 ndc = clip / clip.w;
  return {(ndc.x + 1) / 2, camera.conventions.uv_starts_at_top ? (1 - ndc.y) / 2 : (1 + ndc.y) / 2,
          camera.conventions.depth_is_zero_to_one ? ndc.z : (ndc.z + 1) / 2};
}

TEST(ScreenToWorld, PixelsOfEveryCameraComeBack) {
  SetupGenerator generator(31);
  for (const GoldenCamera& camera : golden_cameras(200, generator)) {
    const auto matrix = screen_to_world(camera.view, camera.gpu_projection, camera.conventions);
    ASSERT_TRUE(matrix) << camera.name;
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 pixel(generator.uniform(0, 1), generator.uniform(0, 1), generator.uniform(0.05, 0.95));
      const Vec4 world = Mat4(*matrix) * Vec4(pixel, 1);
      const glm::dvec3 back = stored(camera, world / world.w);
      EXPECT_LT(glm::length(back - pixel), 1e-6) << camera.name;
    }
  }
}

TEST(ScreenToWorld, TheMiddleOfTheNearPlaneIsInFrontOfTheCamera) {
  SetupGenerator generator(32);
  const GoldenCamera camera = golden_cameras(0, generator).front();
  const auto matrix = screen_to_world(camera.view, camera.gpu_projection, camera.conventions);
  ASSERT_TRUE(matrix);
  const glm::dvec4 world = *matrix * glm::dvec4(0.5, 0.5, 1.0, 1.0);
  EXPECT_LT(glm::length(glm::dvec3(world) / world.w - glm::dvec3(0, 0, -0.3)), 1e-6);
}

TEST(ScreenToWorld, ASingularMatrixHasNoAnswer) {
  EXPECT_FALSE(screen_to_world(glm::dmat4(1.0), glm::dmat4(0.0), {}));
  EXPECT_FALSE(screen_to_world(glm::dmat4(0.0), glm::dmat4(1.0), {}));
  glm::dmat4 broken(1.0);
  broken[2][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(screen_to_world(broken, glm::dmat4(1.0), {}));
}

}  // namespace
}  // namespace penumbra::parameters
