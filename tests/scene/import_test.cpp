#include <gtest/gtest.h>

#include "scene/import_fixture.h"
#include "scene/mesh_properties.h"

namespace penumbra::scene {
namespace {

const ImportOptions kBare{.ground = false};

TEST_F(ImportTest, MirrorsXAndKeepsTheOutside) {
  const Scene scene = import(write("tetrahedron.obj", kTetrahedron), kBare);
  EXPECT_EQ(scene.mesh.triangle_count(), 4U);
  EXPECT_EQ(open_edges(scene.mesh), 0U);
  EXPECT_NEAR(volume(scene.mesh), 1.0, 1e-6);  // 1 * 2 * 3 / 6 is positive: the winding still points out
  // The tall edge stood at the file's least x; in Unity's space that is the greatest.
  for (const glm::vec3& p : scene.mesh.positions) {
    if (p.y > 1.9F) {
      EXPECT_NEAR(p.x, 0.5, 1e-6);
    }
  }
}

TEST_F(ImportTest, StandsTheModelOverTheOrigin) {
  const parameters::Bounds box = import(write("tetrahedron.obj", kTetrahedron), kBare).bounds();
  EXPECT_NEAR(glm::distance(box.minimum, glm::dvec3(-0.5, 0.0, -1.5)), 0.0, 1e-6);
  EXPECT_NEAR(glm::distance(box.maximum, glm::dvec3(0.5, 2.0, 1.5)), 0.0, 1e-6);
}

TEST_F(ImportTest, ScalesByUnitOrToAHeight) {
  const auto file = write("tetrahedron.obj", kTetrahedron);
  EXPECT_NEAR(import(file, {.metres_per_unit = 0.5, .ground = false}).bounds().maximum.y, 1.0, 1e-6);
  EXPECT_NEAR(import(file, {.height_metres = 7.0, .ground = false}).bounds().maximum.y, 7.0, 1e-6);
}

TEST_F(ImportTest, TurnsTheAxisThatIsUpToY) {
  const auto file = write("tetrahedron.obj", kTetrahedron);
  const Scene z_up = import(file, {.z_up = true, .ground = false});
  EXPECT_NEAR(z_up.bounds().maximum.y, 3.0, 1e-6);
  EXPECT_NEAR(volume(z_up.mesh), 1.0, 1e-6);
  const Scene minus = import(file, {.minus_z_up = true, .ground = false});
  EXPECT_NEAR(volume(minus.mesh), 1.0, 1e-6);
  // The wide face, at the file's z = 0, is below in one and above in the other.
  const auto lowest = [](const Scene& s) {
    return std::count_if(s.mesh.positions.begin(), s.mesh.positions.end(),
                         [](auto p) { return p.y < 1e-6F; });
  };
  EXPECT_GT(lowest(z_up), lowest(minus));
}

TEST_F(ImportTest, ReadsGltfWithItsNodesTransformAndMirroring) {
  const std::vector<float> triangle{0, 0, 0, 1, 0, 0, 0, 1, 0};  // its outside looks towards +z
  const Scene plain = import(write("plain.gltf", gltf(triangle)), kBare);
  ASSERT_EQ(plain.mesh.triangle_count(), 1U);
  EXPECT_GT(area_vector(plain.mesh, 0).z, 0.0);
  const Scene tall = import(write("tall.gltf", gltf(triangle, R"(,"scale":[1,4,1])")), kBare);
  EXPECT_NEAR(tall.bounds().maximum.y, 4.0, 1e-6);
  // A node that mirrors would turn the outside in, were its winding not turned back.
  const Scene mirrored = import(write("mirrored.gltf", gltf(triangle, R"(,"scale":[-1,1,1])")), kBare);
  EXPECT_GT(area_vector(mirrored.mesh, 0).z, 0.0);
  EXPECT_GT(mirrored.mesh.normals[0].z, 0.99F);
}

TEST_F(ImportTest, SmoothsShallowEdgesAndKeepsSharpOnes) {
  const auto normals_at_ridge = [&](double height) {
    const std::string y = std::to_string(height);
    const std::string roof =
        "v -1 0 0\nv -1 0 1\nv 0 " + y + " 0\nv 0 " + y + " 1\nv 1 0 0\nv 1 0 1\nf 1 2 4 3\nf 3 4 6 5\n";
    const Scene scene = import(write("roof.obj", roof), kBare);
    std::vector<glm::vec3> normals;
    for (std::size_t i = 0; i < scene.mesh.positions.size(); ++i) {
      if (std::abs(scene.mesh.positions[i].x) < 1e-3F) normals.push_back(scene.mesh.normals[i]);
    }
    return normals;
  };
  for (const glm::vec3& normal : normals_at_ridge(0.3)) EXPECT_NEAR(normal.y, 1.0, 1e-5);  // 33 degrees
  for (const glm::vec3& normal : normals_at_ridge(2.0)) EXPECT_LT(normal.y, 0.5);          // 127 degrees
}

TEST_F(ImportTest, KeepsTheFilesNormals) {
  const Scene scene =
      import(write("normal.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nf 1//1 2//1 3//1\n"), kBare);
  for (const glm::vec3& normal : scene.mesh.normals)
    EXPECT_NEAR(glm::distance(normal, {-0.6F, 0, 0.8F}), 0, 1e-6);
}

TEST_F(ImportTest, DropsTrianglesWithoutAreaAndLines) {
  const Scene scene = import(write("mixed.obj", kTetrahedron + "v 2 0 0\nf 1 2 5\nf 1 1 2\nl 1 2\n"), kBare);
  EXPECT_EQ(scene.mesh.triangle_count(), 4U);
}

TEST_F(ImportTest, FramesTheModelFromOutsideIt) {
  for (const double height : {0.05, 1.0, 30.0, 900.0}) {
    const Scene scene =
        import(write("tetrahedron.obj", kTetrahedron), {.height_metres = height, .ground = false});
    const parameters::Bounds box = scene.bounds();
    const glm::dvec3 eye = scene.camera.position;
    EXPECT_LT(eye.z, box.minimum.z) << height;
    EXPECT_GT(eye.y, 0.5 * box.maximum.y) << height;
    EXPECT_LT(scene.camera.near_plane, glm::distance(eye, box.maximum)) << height;
    EXPECT_GE(scene.shadow_distance_metres, glm::distance(eye, box.maximum));
  }
}

TEST_F(ImportTest, PutsGroundUnderTheModelUnlessToldNot) {
  const auto file = write("tetrahedron.obj", kTetrahedron);
  const Scene with = import(file, {});
  EXPECT_EQ(with.mesh.triangle_count(), 6U);
  EXPECT_NEAR(first_hit(with.mesh, with.camera.position, {0, -1, 0}), with.camera.position.y, 1e-5);
  EXPECT_TRUE(std::isinf(first_hit(import(file, kBare).mesh, with.camera.position, {0, -1, 0})));
}

}  // namespace
}  // namespace penumbra::scene
