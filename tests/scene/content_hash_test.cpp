#include "scene/content_hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

#include "scene/scene.h"

namespace penumbra::scene {
namespace {

TEST(ContentHash, OfASceneChangesWithEverythingThatIsSeen) {
  const Scene scene = built_in("slabs");
  const std::vector<std::function<void(Scene&)>> changes{
      [](Scene& s) { s.mesh.positions[7].y += 1e-6F; },
      [](Scene& s) { s.mesh.normals[7].y = -s.mesh.normals[7].y - 1.0F; },
      [](Scene& s) { std::swap(s.mesh.indices[0], s.mesh.indices[1]); },
      [](Scene& s) { s.origin.x = 1e5; },
      [](Scene& s) { s.light_direction.z += 1e-9; },
      [](Scene& s) { s.shadow_distance_metres = 60.0; },
      [](Scene& s) { s.camera.position.y = 1.75; },
      [](Scene& s) { s.camera.forward.x += 1e-9; },
      [](Scene& s) { s.camera.up.x += 1e-9; },
      [](Scene& s) { s.camera.fov_y_degrees = 61.0; },
      [](Scene& s) { s.camera.aspect = 2.0; },
      [](Scene& s) { s.camera.near_plane = 0.2; },
      [](Scene& s) { s.camera.far_plane = 900.0; },
  };
  std::set<std::string> hashes{content_hash(scene)};
  for (const auto& change : changes) {
    Scene changed = scene;
    change(changed);
    hashes.insert(content_hash(changed));
  }
  EXPECT_EQ(hashes.size(), changes.size() + 1);
}

TEST(ContentHash, OfASceneIgnoresWhatItIsCalled) {
  Scene scene = built_in("slabs");
  const std::string before = content_hash(scene);
  scene.name = "other";
  scene.description = "other";
  EXPECT_EQ(content_hash(scene), before);
}

TEST(ContentHash, OfASceneIgnoresItsPaint) {
  Scene scene = built_in("slabs");
  const std::string before = content_hash(scene);
  scene.materials.front().base_colour = {1.0F, 0.0F, 0.0F};
  scene.textures.push_back({1, 1, {255, 0, 0, 255}});
  scene.mesh.triangle_materials.clear();
  scene.mesh.uvs.resize(scene.mesh.positions.size());
  EXPECT_EQ(content_hash(scene), before);
}

}  // namespace
}  // namespace penumbra::scene
