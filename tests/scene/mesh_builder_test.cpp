#include "scene/mesh_builder.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "scene/mesh_properties.h"

namespace penumbra::scene {
namespace {

void expect_normals_agree_with_winding(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 normal(mesh.normals[mesh.indices[3 * i + k]]);
      EXPECT_GT(glm::dot(normal, area_vector(mesh, i)), 0.0) << "triangle " << i << " corner " << k;
    }
  }
}

TEST(MeshBuilder, BoxIsClosedAndHasItsVolumeHoweverTurned) {
  for (const glm::dmat3& turned :
       {rotation(0.0), rotation(30.0, 20.0, 70.0), rotation(-145.0, 80.0, -200.0)}) {
    MeshBuilder builder;
    builder.box({{3.0, 4.0, -5.0}, turned}, {0.5, 1.5, 2.0});
    const Mesh mesh = builder.take();
    EXPECT_EQ(mesh.triangle_count(), 12U);
    EXPECT_EQ(open_edges(mesh), 0U);
    EXPECT_NEAR(volume(mesh), 1.5, 1e-4);
    expect_normals_agree_with_winding(mesh);
  }
}

TEST(MeshBuilder, HeightsAreASmoothSurfaceThatFacesUp) {
  MeshBuilder builder;
  const auto height = [](int x, int z) { return 0.5 * x - 0.25 * z; };
  std::vector<double> heights;
  for (int z = 0; z <= 3; ++z)
    for (int x = 0; x <= 3; ++x) heights.push_back(height(x, z));
  builder.heights({10.0, -4.0}, 2.0, 3, heights);
  const Mesh mesh = builder.take();
  EXPECT_EQ(mesh.triangle_count(), 18U);
  EXPECT_EQ(mesh.positions.size(), 16U);
  expect_normals_agree_with_winding(mesh);
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) area += 0.5 * area_vector(mesh, i).y;
  EXPECT_NEAR(area, 36.0, 1e-5);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    EXPECT_NEAR(p.y, height(static_cast<int>((p.x - 10.0F) / 2.0F), static_cast<int>((p.z + 4.0F) / 2.0F)),
                1e-6);
    // The plane rises by 0.25 along x and falls by 0.125 along z; at the border slopes are halved.
    if (i != 5 && i != 6) continue;
    EXPECT_NEAR(-mesh.normals[i].x / mesh.normals[i].y, 0.25, 1e-5);
    EXPECT_NEAR(mesh.normals[i].z / mesh.normals[i].y, 0.125, 1e-5);
  }
}

TEST(MeshBuilder, StandingBoxStandsOnItsBase) {
  MeshBuilder builder;
  builder.standing_box({0.0, 2.0, 0.0}, {1.0, 3.0, 1.0}, 45.0);
  Scene scene;
  scene.mesh = builder.take();
  EXPECT_NEAR(scene.bounds().minimum.y, 2.0, 1e-6);
  EXPECT_NEAR(scene.bounds().maximum.y, 5.0, 1e-6);
  EXPECT_NEAR(scene.bounds().maximum.x, std::numbers::sqrt2 / 2.0, 1e-6);
}

TEST(MeshBuilder, TubeIsClosedAndHasThePyramidsVolumeAtEveryAttitude) {
  constexpr int sides = 7;
  // The volume is that of a frustum over a regular polygon: h/3 (A + B + sqrt(A B)).
  const auto polygon = [](double r) {
    return 0.5 * sides * r * r * std::sin(2.0 * std::numbers::pi / sides);
  };
  for (const glm::dvec3& end : {glm::dvec3(0, 2, 0), glm::dvec3(0, -2, 0), glm::dvec3(2, 0, 0),
                                glm::dvec3(1.2, 1.6, 0.0), glm::dvec3(0, 0, -2)}) {
    MeshBuilder builder;
    builder.tube({{0, 0, 0}, end, 0.5, 0.2, sides});
    const Mesh mesh = builder.take();
    EXPECT_EQ(open_edges(mesh), 0U);
    const double expected =
        2.0 / 3.0 * (polygon(0.5) + polygon(0.2) + std::sqrt(polygon(0.5) * polygon(0.2)));
    EXPECT_NEAR(volume(mesh), expected, 1e-4);
    expect_normals_agree_with_winding(mesh);
  }
}

TEST(MeshBuilder, GableIsAClosedPrism) {
  MeshBuilder builder;
  builder.gable({{1.0, 2.0, 3.0}, {4.0, 1.0, 10.0}});
  const Mesh mesh = builder.take();
  EXPECT_EQ(open_edges(mesh), 0U);
  EXPECT_NEAR(volume(mesh), 20.0, 1e-4);
  expect_normals_agree_with_winding(mesh);
}

TEST(MeshBuilder, LatheIsClosedAndHasTheVolumeOfItsRings) {
  // The outline is a cup: out along the foot, up, over the lip and down the inside to the axis.
  MeshBuilder builder;
  builder.lathe({{{1.0, 2.0, 3.0}, rotation(20.0, 30.0, 40.0)},
                 {{0.0, 0.0}, {0.4, 0.0}, {0.5, 1.0}, {0.4, 1.0}, {0.3, 0.1}, {0.0, 0.1}},
                 16});
  const Mesh mesh = builder.take();
  EXPECT_EQ(open_edges(mesh), 0U);
  // The frustums stand on a regular polygon of 16 sides, whose area is 8 r^2 sin(22.5 degrees).
  const auto frustum = [](double a, double b, double height) {
    return height / 3.0 * (a * a + b * b + a * b) * 8.0 * std::sin(std::numbers::pi / 8.0);
  };
  EXPECT_NEAR(volume(mesh), frustum(0.4, 0.5, 1.0) - frustum(0.3, 0.4, 0.9), 1e-4);
  expect_normals_agree_with_winding(mesh);
}

TEST(MeshBuilder, LatheIsSmoothWhereItBendsLittleAndCreasedWhereItBendsMuch) {
  MeshBuilder builder;
  builder.lathe({{}, {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.9, 2.0}, {0.0, 2.0}}, 64});
  const Mesh mesh = builder.take();
  std::set<int> at_foot, at_bend;  // heights of normals, in hundredths
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const int lean = static_cast<int>(std::lround(100.0 * mesh.normals[i].y));
    if (std::abs(glm::length(glm::dvec3(mesh.positions[i]) - glm::dvec3(0, mesh.positions[i].y, 0)) - 1.0) >
        1e-3)
      continue;
    (mesh.positions[i].y == 0.0F ? at_foot : at_bend).insert(lean);
  }
  EXPECT_EQ(at_foot, (std::set<int>{-100, 0}));  // the sole and the wall
  EXPECT_EQ(at_bend, (std::set<int>{5}));        // halfway between 0 and 10
}

TEST(MeshBuilder, BarIsClosedAlongItsBendsAndHasAboutItsVolume) {
  MeshBuilder builder;
  builder.bar({{{0, 0, 0}, {1, 0, 0}, {1.9, 0.3, 0}, {2.5, 1.0, 0.2}}, 0.05, 12});
  const Mesh mesh = builder.take();
  EXPECT_EQ(open_edges(mesh), 0U);
  const double length = 1.0 + std::sqrt(0.9) + std::sqrt(0.36 + 0.49 + 0.04);
  EXPECT_NEAR(volume(mesh), length * 6.0 * 0.0025 * std::sin(std::numbers::pi / 6.0), 5e-4);
  expect_normals_agree_with_winding(mesh);
}

TEST(MeshBuilder, RoundedBoxIsClosedAndAlmostABoxHewnOrNot) {
  RoundedBox box{{{1.0, 0.0, 2.0}, rotation(30.0, 10.0)}, {2.0, 1.0, 0.5}, 0.05};
  for (const double hewn : {0.0, 0.04}) {
    for (std::size_t corner = 0; corner < 8; ++corner) {
      box.corner_shift[corner] =
          hewn * glm::dvec3(corner % 2 == 0 ? 1.0 : -1.0, corner % 3 == 0 ? 1.0 : -1.0, 0.5);
    }
    MeshBuilder builder;
    builder.rounded_box(box);
    const Mesh mesh = builder.take();
    EXPECT_EQ(mesh.triangle_count(), 108U);
    EXPECT_EQ(open_edges(mesh), 0U) << hewn;
    EXPECT_NEAR(volume(mesh), 1.0, 0.12) << hewn;
    EXPECT_LT(volume(mesh), 1.0) << hewn;
    expect_normals_agree_with_winding(mesh);
  }
}

TEST(MeshBuilder, LeafLooksTowardsAlongCrossAcross) {
  MeshBuilder builder;
  builder.leaf({{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, 0.1, 0.05});
  const Mesh mesh = builder.take();
  EXPECT_EQ(mesh.triangle_count(), 4U);
  for (const glm::vec3& normal : mesh.normals) EXPECT_GT(normal.y, 0.9F);
  expect_normals_agree_with_winding(mesh);
}

// A texture of one metre lies on the surface at one metre, with u along the longer edge.
TEST(MeshBuilder, TextureCoordinatesAreMetresAlongTheGrain) {
  for (const double metres : {1.0, 0.5}) {
    MeshBuilder builder;
    builder.use(Material{}, metres);
    builder.quad({glm::dvec3(0, 0, 0), glm::dvec3(0, 0, 3), glm::dvec3(2, 0, 3), glm::dvec3(2, 0, 0)});
    builder.tube({{5, 0, 0}, {5, 4, 0}, 0.3, 0.3, 8});
    const Mesh mesh = builder.take();
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
    EXPECT_NEAR(std::abs(mesh.uvs[1].x - mesh.uvs[0].x) * metres, 3.0, 1e-5);
    EXPECT_NEAR(mesh.uvs[1].y, mesh.uvs[0].y, 1e-6);
    EXPECT_NEAR(std::abs(mesh.uvs[2].y - mesh.uvs[1].y) * metres, 2.0, 1e-5);
    EXPECT_NEAR((mesh.uvs[5].x - mesh.uvs[4].x) * metres, 4.0, 1e-5);
  }
}

TEST(MeshBuilder, GroundFacesUp) {
  MeshBuilder builder;
  builder.ground({1.0, 0.0, 2.0}, 5.0);
  const Mesh mesh = builder.take();
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 1, 0));
  expect_normals_agree_with_winding(mesh);
}

TEST(MeshBuilder, PaintsWhatFollowsWithTheMaterialInUse) {
  const auto named = [](const char* name) {
    Material material;
    material.name = name;
    return material;
  };
  MeshBuilder builder;
  builder.ground({}, 1.0);
  builder.use(named("stone"));
  builder.ground({}, 2.0);
  builder.use(named("wood"));
  builder.ground({}, 3.0);
  builder.use(named("stone"));
  builder.ground({}, 4.0);
  Scene scene;
  builder.move_into(scene);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.mesh.triangle_count(); i += 2) {
    EXPECT_EQ(scene.mesh.material_of(i), scene.mesh.material_of(i + 1));
    names.push_back(scene.materials.at(scene.mesh.material_of(i)).name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"grey", "stone", "wood", "stone"}));
  EXPECT_EQ(scene.materials.size(), 3U);
}

TEST(MeshBuilder, RotationTurnsZTowardsXAndKeepsSizes) {
  const glm::dvec3 turned = rotation(90.0) * glm::dvec3(0, 0, 1);
  EXPECT_NEAR(turned.x, 1.0, 1e-12);
  const glm::dmat3 any = rotation(12.0, 34.0, 56.0);
  EXPECT_NEAR(glm::dot(any[0], glm::cross(any[1], any[2])), 1.0, 1e-12);
}

}  // namespace
}  // namespace penumbra::scene
