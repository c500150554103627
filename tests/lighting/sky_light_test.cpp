#include "lighting/sky_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "lighting/hand_made.h"
#include "reference/scratch_folder.h"

namespace penumbra::lighting {
namespace {

const glm::dvec3 kToSun = glm::normalize(glm::dvec3(0.2, 1.0, 0.1));

SkyDome uniform(double radiance) {
  return SkyDome([radiance](const glm::dvec3&) { return glm::dvec3(radiance); });
}

scene::Scene floor_scene() {
  scene::Scene scene = hand_made::looking_down(10.0, kToSun);
  hand_made::add_square(scene, {0, 0, 0}, {20, 0, 0}, {0, 0, 20});
  return scene;
}

// A plane under a uniform sky receives pi times its radiance: a white one is as bright as the sky.
TEST(SkyLight, OnAPlaneUnderAUniformSkyIsTheSkys) {
  const scene::Scene scene = floor_scene();
  const SeenMaterials seen = seen_materials(scene, hand_made::frame_of(scene, 8, 8));
  const SkyDome sky = uniform(2.5);
  for (const int rays : {1, 16, 64}) {
    for (const glm::vec3& light : sky_light(scene, seen, {sky, glm::vec3(kToSun), glm::vec3(9.0F)}, rays)) {
      ASSERT_NEAR(light.g, 2.5F, 1e-4F) << rays;
    }
  }
}

// In a closed box whose walls see nothing of sky or sun there is only what the bound for others lets pass.
TEST(SkyLight, WhatIsMetIsNeverBrighterThanItsColourAllows) {
  scene::Scene scene = floor_scene();
  scene.materials[0].base_colour = glm::vec3(1.0F);
  hand_made::add_square(scene, {0, 12, 0}, {20, 0, 0}, {0, 0, -20});
  for (const glm::dvec3 side :
       {glm::dvec3(20, 6, 0), glm::dvec3(-20, 6, 0), glm::dvec3(0, 6, 20), glm::dvec3(0, 6, -20)}) {
    const glm::dvec3 along = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), side));
    hand_made::add_square(scene, side, along * 20.5, {0, 6.5, 0});
  }
  const SeenMaterials seen = seen_materials(scene, hand_made::frame_of(scene, 8, 8));
  const SkyDome sky = uniform(1.0);
  for (const glm::vec3& light : sky_light(scene, seen, {sky, glm::vec3(kToSun), glm::vec3(100.0F)}, 64)) {
    EXPECT_LE(light.g, 1.0F) << "the box keeps the sun out";
    EXPECT_GT(light.g, 0.0F);
  }
}

// Half of the cosine-weighted hemisphere beside an endless wall is hidden; near a long one, almost.
TEST(SkyLight, AWallHidesHalfOfTheSkyAtItsFoot) {
  scene::Scene scene = hand_made::looking_down(10.0, {0.0, 1.0, 0.0});
  hand_made::add_square(scene, {0, 0, 0}, {200, 0, 0}, {0, 0, 200});
  scene.materials.push_back({.name = "black", .base_colour = glm::vec3(0.0F)});
  hand_made::add_square(scene, {0.5, 100, 0}, {0, 0, 400}, {0, 100, 0}, 1);
  scene.camera.position = {0.0, 10.0, 0.0};
  const SeenMaterials seen = seen_materials(scene, hand_made::frame_of(scene, 5, 5));
  const SkyDome sky = uniform(1.0);
  const std::vector<glm::vec3> light =
      sky_light(scene, seen, {sky, {0.0F, 1.0F, 0.0F}, glm::vec3(0.0F)}, 1024);
  EXPECT_NEAR(light[12].g, 0.5F, 0.02F) << "half a metre before it";
}

// A sunlit floor beside a lit ceiling's sight sends light up to what faces it.
TEST(SkyLight, SunlitGroundLightsWhatFacesIt) {
  scene::Scene scene = hand_made::looking_down(10.0, {0.0, 1.0, 0.0});
  hand_made::add_square(scene, {0, 0, 0}, {200, 0, 0}, {0, 0, 200});
  scene.materials[0].base_colour = {0.5F, 0.25F, 0.0F};
  const SkyDome dark = uniform(0.0);
  SeenMaterials seen;
  seen.width = seen.height = 1;
  seen.seen = {1};
  seen.points.resize(1);
  seen.points[0].position = {0.0F, 3.0F, 0.0F};
  seen.points[0].flat_normal = seen.points[0].normal = {0.0F, -1.0F, 0.0F};
  const glm::vec3 light = sky_light(scene, seen, {dark, {0.0F, 1.0F, 0.0F}, glm::vec3(8.0F)}, 256)[0];
  EXPECT_NEAR(light.r, 0.5 * 8.0 / std::numbers::pi, 0.02) << "reflectance times irradiance over pi";
  EXPECT_NEAR(light.g, 0.25 * 8.0 / std::numbers::pi, 0.01);
  EXPECT_EQ(light.b, 0.0F);
}

// A black ceiling is above the translucent surface, and the sky below. Its share of the rays goes there.
TEST(SkyLight, ATranslucentSurfaceHasItsShareFromBehind) {
  scene::Scene scene = floor_scene();
  scene.materials.push_back({.name = "black", .base_colour = glm::vec3(0.0F)});
  hand_made::add_square(scene, {0, 2, 0}, {500, 0, 0}, {0, 0, 500}, 1);
  SeenMaterials seen;
  seen.width = seen.height = 1;
  seen.seen = {1};
  seen.points.resize(1);
  seen.points[0].flat_normal = seen.points[0].normal = {0.0F, 1.0F, 0.0F};
  seen.points[0].translucency = 0.25F;
  const SkyDome sky = uniform(1.0);
  EXPECT_NEAR(sky_light(scene, seen, {sky, glm::vec3(kToSun), glm::vec3(0.0F)}, 64)[0].g, 0.25F, 0.01F);
}

TEST(SkyLight, IsTheSameOnAnyNumberOfThreadsAndFromTheFolderThatKeepsIt) {
  scene::Scene scene = floor_scene();
  hand_made::add_square(scene, {2, 1, 0}, {1, 0, 0}, {0, 0, 1});
  const SeenMaterials seen = seen_materials(scene, hand_made::frame_of(scene, 32, 32));
  const SkyDome sky([](const glm::dvec3& d) { return glm::dvec3(1.0 + d.x); });
  const Surroundings surroundings{sky, glm::vec3(kToSun), glm::vec3(3.0F)};
  reference::RunOptions one;
  one.jobs = 1;
  const std::vector<glm::vec3> light = sky_light(scene, seen, surroundings, 16, one);
  EXPECT_EQ(light, sky_light(scene, seen, surroundings, 16));
  const reference::ScratchFolder folder;
  EXPECT_EQ(light, kept_sky_light(scene, seen, surroundings, 16, folder.path(), {}));
  reference::RunOptions never;
  never.cancelled = [] { return true; };
  EXPECT_EQ(light, kept_sky_light(scene, seen, surroundings, 16, folder.path(), never))
      << "not gathered again";
  EXPECT_THROW(kept_sky_light(scene, seen, surroundings, 32, folder.path(), never), platform::Interrupted);
  scene.materials[0].base_colour = glm::vec3(0.1F);
  EXPECT_THROW(kept_sky_light(scene, seen, surroundings, 16, folder.path(), never), platform::Interrupted)
      << "another colour is another light";
}

// Cut-out triangles are asked about apart from the others; the colours that rays bring stay those of what
// they meet.
TEST(SkyLight, CutOutsKeepTheirPlaceAndOpenOnesLetThrough) {
  scene::Scene scene = floor_scene();
  scene.materials.push_back({.name = "red", .base_colour = {1.0F, 0.0F, 0.0F}});
  hand_made::add_square(scene, {3, 3, 0}, {0, 0, 3}, {0, 3, 0}, 1);
  hand_made::add_square(scene, {-3, 3, 0}, {0, 0, 3}, {0, 3, 0}, 0);
  const SeenMaterials seen = seen_materials(scene, hand_made::frame_of(scene, 8, 8));
  const SkyDome sky = uniform(1.0);
  const Surroundings surroundings{sky, glm::vec3(kToSun), glm::vec3(3.0F)};
  const reference::ScratchFolder folder;
  const auto light = [&] { return kept_sky_light(scene, seen, surroundings, 64, folder.path(), {}); };
  const std::vector<glm::vec3> solid = light();
  scene.materials[1].cut_out = scene::CutOut{.factor = 1.0F, .cutoff = 0.5F};
  EXPECT_EQ(light(), solid);
  scene.materials[1].cut_out->factor = 0.0F;
  const std::vector<glm::vec3> open = light();
  EXPECT_NE(open, solid);
  scene.materials[1].cut_out.reset();
  scene.mesh.indices.erase(scene.mesh.indices.begin() + 6, scene.mesh.indices.begin() + 12);
  scene.mesh.triangle_materials.erase(scene.mesh.triangle_materials.begin() + 2,
                                      scene.mesh.triangle_materials.begin() + 4);
  EXPECT_EQ(light(), open) << "as if the red wall were not there";
}

TEST(SmoothedLight, LeavesConstantLightAndEdgesAlone) {
  scene::Scene scene = floor_scene();
  hand_made::add_square(scene, {2, 1, 0}, {1.5, 0, 0}, {0, 0, 1.5});
  const SeenMaterials seen = seen_materials(scene, hand_made::frame_of(scene, 32, 32));
  const std::vector<glm::vec3> constant(seen.points.size(), glm::vec3(0.75F));
  for (const glm::vec3& light : smoothed(seen, constant, 3)) ASSERT_NEAR(light.g, 0.75F, 1e-6F);
  std::vector<glm::vec3> stepped(seen.points.size());
  for (std::size_t i = 0; i < stepped.size(); ++i)
    stepped[i] = glm::vec3(seen.points[i].position.y > 0.5F ? 1.0F : 0.0F);
  EXPECT_EQ(smoothed(seen, stepped, 2), stepped) << "the square stands off the floor";
}

}  // namespace
}  // namespace penumbra::lighting
