// Tests the scenes with ground beyond the shadow distance.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <set>

#include "as_identifier.h"
#include "scene/content_hash.h"
#include "scene/mesh_properties.h"
#include "scene/scene.h"

namespace penumbra::scene {
namespace {

class Landscape : public testing::TestWithParam<std::string> {
 protected:
  const Scene scene = built_in(GetParam());

  glm::dvec3 corner(std::size_t triangle, std::size_t k) const {
    return glm::dvec3(scene.mesh.positions[scene.mesh.indices[3 * triangle + k]]);
  }
};

TEST_P(Landscape, IsTheSameToTheByteEverywhere) {
  const std::map<std::string, std::string> golden{
      {"valley-5", "053dc365f04e9560171f9bd69a3080087e1cd6ebebc6890a11d48f826843c8b7"},
      {"valley-20", "4224ffe115cc77231661010f902a63af72a295a73d548ef2a48f7da0332b2b80"},
      {"valley-20-clouds", "aa84556067243ae42b4ac5410708d42fe45eded3acaf7b92809a89a1a32ad3b9"},
      {"valley-45", "a2750eea6f93389db9b04c6e5748ee101d107ec8aef5b044cdc1792d5d26bf63"}};
  EXPECT_EQ(content_hash(scene), golden.at(GetParam()));
}

TEST_P(Landscape, BeginsWithItsGroundOnAGridOfTenKilometres) {
  ASSERT_GT(scene.ground_triangles, 500'000U);
  ASSERT_LT(scene.ground_triangles, scene.mesh.triangle_count());
  double area = 0.0;
  std::set<double> columns;
  for (std::size_t i = 0; i < scene.ground_triangles; ++i) {
    const glm::dvec3 across = area_vector(scene.mesh, i);
    ASSERT_GT(across.y, 0.0) << "triangle " << i << " does not face up";
    area += 0.5 * across.y;
    for (std::size_t k = 0; k < 3; ++k) columns.insert(corner(i, k).x);
  }
  EXPECT_NEAR(area, 1e8, 1.0);
  EXPECT_EQ(columns.size(), 641U);
  EXPECT_EQ(*columns.begin(), -5000.0);
  EXPECT_EQ(*columns.rbegin(), 5000.0);
}

TEST_P(Landscape, LooksFromAboveTheGroundUnderASunOfItsElevation) {
  const glm::dvec3 eye = scene.camera.position;
  double height = -1.0;
  for (std::size_t i = 0; i < scene.ground_triangles && height < 0.0; ++i) {
    const glm::dvec3 a = corner(i, 0), b = corner(i, 1), c = corner(i, 2);
    const auto side = [&](const glm::dvec3& p, const glm::dvec3& q) {
      return (q.x - p.x) * (eye.z - p.z) - (q.z - p.z) * (eye.x - p.x);
    };
    const double u = side(b, c), v = side(c, a), w = side(a, b);
    if (!((u <= 0.0 && v <= 0.0 && w <= 0.0) || (u >= 0.0 && v >= 0.0 && w >= 0.0))) continue;
    height = eye.y - (u * a.y + v * b.y + w * c.y) / (u + v + w);
  }
  EXPECT_NEAR(height, 25.0, 0.01);
  const double wanted = GetParam() == "valley-5" ? 5.0 : GetParam() == "valley-45" ? 45.0 : 20.0;
  EXPECT_NEAR(glm::degrees(std::asin(-scene.light_direction.y)), wanted, 1e-6);
  EXPECT_EQ(scene.clouds.has_value(), GetParam() == "valley-20-clouds");
  EXPECT_GT(scene.seen_distance_metres, 10.0 * scene.shadow_distance_metres);
  EXPECT_GT(scene.camera.far_plane, scene.seen_distance_metres);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Landscape,
                         testing::Values("valley-5", "valley-20", "valley-20-clouds", "valley-45"),
                         [](const auto& test) { return as_identifier(test.param); });

}  // namespace
}  // namespace penumbra::scene
