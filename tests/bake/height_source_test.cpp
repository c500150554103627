// Compares heights of a scene with the triangles it is made of, and those of an image with its numbers.
#include "bake/height_source.h"

#include <gmock/gmock.h>

#include <cmath>

#include "input/input_error_matcher.h"

namespace penumbra::bake {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// The scene is a slope y = 1 + x / 2 over [0, 4] x [0, 2], and over a part of it a level roof at y = 5.
scene::Scene slope_and_roof() {
  scene::Scene scene;
  scene.name = "slope";
  const auto quad = [&](float x0, float x1, float z0, float z1, auto height) {
    const auto first = static_cast<std::uint32_t>(scene.mesh.positions.size());
    for (const auto& [x, z] : {std::pair{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}}) {
      scene.mesh.positions.emplace_back(x, height(x), z);
      scene.mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) scene.mesh.indices.push_back(first + corner);
  };
  quad(0.0F, 4.0F, 0.0F, 2.0F, [](float x) { return 1.0F + 0.5F * x; });
  quad(1.5F, 2.5F, 0.5F, 1.5F, [](float) { return 5.0F; });
  return scene;
}

TEST(HeightSource, OfASceneIsItsHighestSurface) {
  const scene::Scene scene = slope_and_roof();
  const Area area = area_of(scene);
  EXPECT_EQ(area, (Area{{0.0, 0.0}, {4.0, 2.0}}));
  // The area lies a little inside of the edges, past which a ray may go.
  const HeightField field = heights_of_scene(scene, {{0.01, 0.01}, {3.98, 1.98}}, {5, 3});
  for (int z = 0; z < 3; ++z) {
    for (int x = 0; x < 5; ++x) {
      const double place = 0.01 + 0.995 * x;
      const double wanted = x == 2 && z == 1 ? 5.0 : 1.0 + 0.5 * place;
      EXPECT_NEAR(field.at(x, z), wanted, 1e-5) << x << " " << z;
    }
  }
}

TEST(HeightSource, BesideTheSceneIsItsLowestHeight) {
  const HeightField field = heights_of_scene(slope_and_roof(), {{-2.0, 1.0}, {4.0, 8.0}}, {3, 2});
  EXPECT_THAT(std::vector<float>(field.metres.begin() + 3, field.metres.end()), testing::Each(1.0F))
      << "z = 9";
  EXPECT_FLOAT_EQ(field.at(0, 0), 1.0F) << "x = -2";
  EXPECT_NEAR(field.at(2, 0), 5.0, 1e-5) << "x = 2";
}

// The scene's bounds are the area that is covered by default: rays along all four sides meet it.
TEST(HeightSource, OfASceneReachesToItsEdges) {
  for (const char* name : {"valley-20", "street", "garden"}) {
    const scene::Scene scene = scene::built_in(name);
    EXPECT_EQ(heights_of_scene(scene, area_of(scene), {17, 9}).holes, 0U) << name;
  }
}

TEST(HeightSource, DoesNotDependOnTheNumberOfThreads) {
  const scene::Scene scene = scene::built_in("street");
  BakeOptions one;
  one.jobs = 1;
  BakeOptions four;
  four.jobs = 4;
  EXPECT_EQ(heights_of_scene(scene, area_of(scene), {33, 65}, one).metres,
            heights_of_scene(scene, area_of(scene), {33, 65}, four).metres);
}

TEST(HeightSource, RefusesAnAreaWithoutGround) {
  const scene::Scene scene = slope_and_roof();
  const auto refuse = [&](const Area& area, const SampleCounts& counts, const char* words) {
    expect_input_error([&] { heights_of_scene(scene, area, counts); }, HasSubstr(words));
  };
  refuse({{50.0, 50.0}, {1.0, 1.0}}, {4, 4}, "no surface");
  refuse({{0.0, 0.0}, {1.0, 0.0}}, {4, 4}, "cannot cover");
  refuse({{0.0, 0.0}, {NAN, 1.0}}, {4, 4}, "cannot cover");
  refuse({{HUGE_VAL, 0.0}, {1.0, 1.0}}, {4, 4}, "cannot cover");
  for (const double huge : {1e19, 1e300, -1e19}) {
    refuse({{huge, 0.0}, {1.0, 1.0}}, {4, 4}, "--area");
    refuse({{0.0, 0.0}, {1.0, huge}}, {4, 4}, "--area");
  }
  refuse(area_of(scene), {0, 4}, "not 0");
  refuse(area_of(scene), {4, 8194}, "not 8194");
}

TEST(HeightSource, OfAnImageIsItsRangeInSteps) {
  const scene::HeightImage image{3, 2, {0, 65535, 13107, 52428, 26214, 0}};
  const Area area{{0.0, 0.0}, {2.0, 1.0}};
  EXPECT_THAT(heights_of_image(image, area, {-10.0, 40.0}).metres,
              ElementsAre(-10.0F, 40.0F, 0.0F, 30.0F, 10.0F, -10.0F));
  EXPECT_THAT(heights_of_image(image, area, {-10.0, 40.0}, true).metres,
              ElementsAre(30.0F, 10.0F, -10.0F, -10.0F, 40.0F, 0.0F));
  const auto refuse = [&](const Area& covered, const HeightRange& heights, const char* words) {
    expect_input_error([&] { heights_of_image(image, covered, heights); }, HasSubstr(words));
  };
  refuse(area, {40.0, 40.0}, "from 40 to 40");
  for (const double huge : {1e308, 1e7, -1e308})
    refuse(area, {std::min(huge, 0.0), std::abs(huge)}, "--heights");
  refuse(area, {0.0, HUGE_VAL}, "cannot go");
  refuse({{0.0, 0.0}, {-2.0, 1.0}}, {0.0, 1.0}, "cannot cover");
}

}  // namespace
}  // namespace penumbra::bake
