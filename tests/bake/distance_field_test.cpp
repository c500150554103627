// Distances against closed forms, and against every triangle one after the other.
#include "bake/distance_field.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "bake/made_shapes.h"
#include "input/input_error_matcher.h"
#include "reference/closest_surface.h"
#include "reference/embree_scene.h"

namespace penumbra::bake {
namespace {

using testing::HasSubstr;

void expect_distances(const DistanceField& field, const std::function<double(const glm::dvec3&)>& wanted,
                      double error) {
  int inside = 0;
  for (int z = 0; z < field.voxels[2]; ++z)
    for (int y = 0; y < field.voxels[1]; ++y)
      for (int x = 0; x < field.voxels[0]; ++x) {
        const double exact = wanted(field.centre(x, y, z));
        ASSERT_NEAR(field.at(x, y, z), exact, error) << x << " " << y << " " << z;
        inside += exact < 0.0 ? 1 : 0;
      }
  EXPECT_GT(inside, 20);
}

TEST(DistanceField, OfABoxIsExact) {
  const glm::dvec3 half(2.0, 1.0, 0.5);
  const DistanceField field = bake_distance_field(box(glm::vec3(half)), {24, 0.25});
  EXPECT_EQ(field.voxels, (std::array{24, 16, 12}));
  EXPECT_EQ(field.open_edges, 0U);
  expect_distances(
      field,
      [&](const glm::dvec3& at) {
        const glm::dvec3 apart = glm::abs(at) - half;
        return glm::length(glm::max(apart, 0.0)) + std::min(std::max({apart.x, apart.y, apart.z}), 0.0);
      },
      1e-6);
}

// The mesh lies inside of the surface that it is cut from, by at most its sagitta.
TEST(DistanceField, OfASphereAndOfATorusAreThoseOfTheirEquations) {
  const double apart = 1.0 - std::cos(kHalfTurn / 64.0) + 1.0 - std::cos(kHalfTurn / 128.0);
  expect_distances(
      bake_distance_field(sphere(1.0, 64, 64), {20, 0.2}),
      [](const glm::dvec3& at) { return glm::length(at) - 1.0; }, apart);
  expect_distances(
      bake_distance_field(torus(2.0, 0.5, 96, 48), {20, 0.1}),
      [](const glm::dvec3& at) {
        return glm::length(glm::dvec2(glm::length(glm::dvec2(at.x, at.z)) - 2.0, at.y)) - 0.5;
      },
      2.5 * (1.0 - std::cos(kHalfTurn / 96.0)) + 0.5 * (1.0 - std::cos(kHalfTurn / 48.0)));
}

TEST(DistanceField, OfAMeshThatIsTurnedInsideOutIsTheSame) {
  scene::Scene turned = torus(2.0, 0.5, 24, 12);
  const DistanceField field = bake_distance_field(turned, {16, 0.1});
  for (std::size_t i = 0; i < turned.mesh.indices.size(); i += 3)
    std::swap(turned.mesh.indices[i], turned.mesh.indices[i + 1]);
  EXPECT_EQ(bake_distance_field(turned, {16, 0.1}).metres, field.metres);
}

// For each shape the search of the hierarchy is compared with a loop over all triangles, at 10^5 places.
TEST(ClosestSurface, IsTheNearestOfAllTriangles) {
  std::mt19937 bits(5);
  const auto chance = [&] { return static_cast<double>(bits()) * 0x1p-32; };
  std::vector<scene::Scene> scenes{box({1.0F, 0.2F, 0.7F}), sphere(1.0, 9, 6), torus(1.0, 0.4, 9, 7)};
  // The triangles are slivers, segments or points.
  std::vector<glm::vec3> positions;
  for (int i = 0; i < 60; ++i)
    positions.emplace_back(glm::vec3(glm::dvec3(chance(), 1e-6 * chance(), chance()) - 0.5));
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i + 2 < 60; i += 2) indices.insert(indices.end(), {i, i + 1, i + 2});
  indices.insert(indices.end(), {3, 3, 9, 5, 5, 5});
  scenes.push_back(mesh_of(positions, indices));
  for (const scene::Scene& scene : scenes) {
    const reference::EmbreeScene rays(scene);
    const reference::ClosestSurface surface(rays, scene);
    for (int i = 0; i < 25'000; ++i) {
      const glm::dvec3 place = 4.0 * (glm::dvec3(chance(), chance(), chance()) - 0.5);
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t triangle = 0; triangle < scene.mesh.triangle_count(); ++triangle) {
        std::array<glm::dvec3, 3> corners;
        for (std::size_t j = 0; j < 3; ++j)
          corners[j] = glm::dvec3(scene.mesh.positions[scene.mesh.indices[3 * triangle + j]]);
        nearest =
            std::min(nearest, glm::distance(place, reference::nearest_on_triangle(place, corners).point));
      }
      ASSERT_NEAR(std::abs(surface.distance(place)), nearest, 1e-12) << glm::length(place);
    }
  }
}

// The normal of one triangle of several may point the wrong way at edges and corners, of every sharpness.
TEST(ClosestSurface, KnowsTheInsideOfAnyTetrahedron) {
  std::mt19937 bits(8);
  const auto place = [&](double size) {
    const auto chance = [&] { return size * (static_cast<double>(bits()) * 0x1p-32 - 0.5); };
    return glm::dvec3(chance(), chance(), chance());
  };
  int inside = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 4; ++i) corners.emplace_back(glm::vec3(place(1.0)));
    if (round % 3 == 0)
      corners[3] = corners[0] + 0.02F * (corners[3] - corners[0]);  // its edges are a needle's or a blade's
    const scene::Scene scene = mesh_of(corners, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
    const reference::EmbreeScene rays(scene);
    const reference::ClosestSurface surface(rays, scene);
    const auto side = [&](const glm::dvec3& at, int a, int b, int c) {
      const auto corner = [&](int i) { return glm::dvec3(corners[static_cast<std::size_t>(i)]); };
      return glm::dot(at - corner(a), glm::cross(corner(b) - corner(a), corner(c) - corner(a)));
    };
    for (int i = 0; i < 300; ++i) {
      // Half of the places are near, because inside is small.
      const glm::dvec3 at =
          i % 2 == 0 ? place(3.0) : glm::dvec3(corners[static_cast<std::size_t>(i / 2 % 4)]) + place(0.1);
      const std::array sides{side(at, 0, 2, 1), side(at, 0, 1, 3), side(at, 0, 3, 2), side(at, 1, 2, 3)};
      const auto signs = std::minmax_element(sides.begin(), sides.end());
      const bool within = *signs.first > 0.0 || *signs.second < 0.0;
      const double distance = surface.distance(at);
      if (std::abs(distance) > 1e-9) {
        ASSERT_EQ(distance < 0.0, within) << round << ": " << distance;
      }
      inside += within ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 1000);
}

// The other points are taken in steps of a thousandth over the triangle.
TEST(NearestOnTriangle, IsNearerThanAnyOtherPoint) {
  std::mt19937 bits(6);
  const auto place_in = [&](double size) {
    const auto chance = [&] { return size * (static_cast<double>(bits()) * 0x1p-32 - 0.5); };
    return glm::dvec3(chance(), chance(), chance());
  };
  for (int round = 0; round < 300; ++round) {
    const std::array corners{place_in(1.0), place_in(1.0), place_in(1.0)};
    const glm::dvec3 place = place_in(3.0);
    const double found = glm::distance(place, reference::nearest_on_triangle(place, corners).point);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 100; ++i)
      for (int j = 0; i + j <= 100; ++j)
        least = std::min(least, glm::distance(place, corners[0] + 0.01 * i * (corners[1] - corners[0]) +
                                                         0.01 * j * (corners[2] - corners[0])));
    EXPECT_LE(found, least + 1e-12);
    EXPECT_GE(found, least - 0.02);
  }
}

TEST(DistanceField, OpenEdgesAreCounted) {
  scene::Scene open = box({1.0F, 1.0F, 1.0F});
  open.mesh.indices.resize(open.mesh.indices.size() - 6);  // one side is missing
  EXPECT_EQ(bake_distance_field(open, {4, 0.1}).open_edges, 4U);
  const scene::Scene sheet = mesh_of({{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}}, {0, 2, 1});
  const DistanceField field = bake_distance_field(sheet, {9, 0.5});
  EXPECT_EQ(field.open_edges, 3U);
  // Both sides of the mesh have their sign.
  const int middle = field.voxels[1] / 2;
  EXPECT_LT(field.at(3, 0, 3) * field.at(3, 2 * middle, 3), 0.0F);
}

TEST(DistanceField, DoesNotDependOnTheNumberOfThreads) {
  BakeOptions one, four;
  one.jobs = 1;
  four.jobs = 4;
  const scene::Scene scene = torus(2.0, 0.5, 24, 12);
  EXPECT_EQ(bake_distance_field(scene, {20, 0.1}, one).metres,
            bake_distance_field(scene, {20, 0.1}, four).metres);
}

TEST(DistanceField, SaysWhatItCannotBake) {
  const scene::Scene whole = box({1.0F, 1.0F, 1.0F});
  const auto refuse = [](const scene::Scene& scene, const DistanceFieldOptions& options, const auto& says) {
    expect_input_error([&] { bake_distance_field(scene, options); }, says);
  };
  refuse(mesh_of({}, {}), {}, HasSubstr("no triangles"));
  refuse(whole, {0, 0.1}, HasSubstr("not 0"));
  refuse(whole, {1, 0.1}, HasSubstr("from 2 to 512 voxels along its longest side, not 1"));
  EXPECT_EQ(placed_field(whole, {2, 0.1}).voxels, (std::array{2, 2, 2}));
  refuse(whole, {513, 0.1}, HasSubstr("not 513"));
  refuse(whole, {8, -0.1}, HasSubstr("margin of -0.1"));
  refuse(whole, {8, std::nan("")}, HasSubstr("margin of nan"));
  scene::Scene broken = whole;
  broken.mesh.positions[3].y = std::numeric_limits<float>::quiet_NaN();
  refuse(broken, {8, 0.1}, HasSubstr("not a finite number"));
  refuse(mesh_of(std::vector<glm::vec3>(3, glm::vec3(1.0F)), {0, 1, 2}), {8, 0.1}, HasSubstr("single point"));
}

}  // namespace
}  // namespace penumbra::bake
