// Tests shadow volumes of meshes: they are closed whatever the mesh is, and inside of them are exactly the
// points that a ray towards the light says.
#include "scene/shadow_volume.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>

#include "input/input_error_matcher.h"
#include "input/json_lines.h"
#include "scene/mesh_properties.h"

namespace penumbra::scene {
namespace {

using testing::HasSubstr;

constexpr double kLength = 40.0;

struct Triangles {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;

  void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    for (const glm::vec3& corner : {a, b, c}) {
      indices.push_back(static_cast<std::uint32_t>(positions.size()));
      positions.push_back(corner);
    }
  }
  void add_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    add(a, b, c);
    add(a, c, d);
  }
  // Normals point outwards.
  void add_box(const glm::vec3& low, const glm::vec3& high) {
    const auto corner = [&](int bits) {
      return glm::vec3((bits & 1) != 0 ? high.x : low.x, (bits & 2) != 0 ? high.y : low.y,
                       (bits & 4) != 0 ? high.z : low.z);
    };
    for (const std::array<int, 4>& face : std::array<std::array<int, 4>, 6>{
             {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}})
      add_quad(corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3]));
  }
};

ShadowVolume volume_of(const Triangles& mesh, const glm::dvec3& light) {
  return shadow_volume(mesh.positions, mesh.indices, kLength * glm::normalize(light));
}

// The number of directed edges that do not cancel.
std::size_t gaps(const ShadowVolume& volume) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (std::size_t first = 0; first < volume.indices.size(); first += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = volume.indices[first + k], to = volume.indices[first + (k + 1) % 3];
      balance[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

// The number of times that a volume contains a point, by the solid angles of its triangles (van Oosterom and
// Strackee 1983).
double times_inside(const ShadowVolume& volume, const glm::dvec3& point) {
  Mesh mesh;
  mesh.positions = volume.positions;
  mesh.indices = volume.indices;
  return winding_number(mesh, point);
}

// The number of triangles between a point and the light, those of closed pieces once for two; absent where an
// edge is near.
std::optional<double> casters_before(const Triangles& mesh, const glm::dvec3& point, const glm::dvec3& light,
                                     const std::function<double(const glm::dvec3&)>& weight) {
  double sum = 0.0;
  const glm::dvec3 to_light = -glm::normalize(light);
  for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[first + k]]); };
    const glm::dvec3 a = at(0), b = at(1) - a, c = at(2) - a, normal = glm::cross(b, c);
    const double slope = glm::dot(normal, to_light);
    if (std::abs(slope) < 1e-12) continue;
    const double distance = glm::dot(normal, a - point) / slope;
    const glm::dvec3 hit = point + distance * to_light - a;
    const double u = glm::dot(glm::cross(hit, c), normal) / glm::dot(normal, normal);
    const double v = glm::dot(glm::cross(b, hit), normal) / glm::dot(normal, normal);
    const double edge = std::min({u, v, 1.0 - u - v});
    if (edge < -1e-4) continue;
    if (edge < 1e-4 || std::abs(distance) < 1e-4) return std::nullopt;
    if (distance > 0.0 && distance < kLength) sum += weight(normal);
  }
  return sum;
}

double every_triangle(const glm::dvec3&) {
  return 1.0;
}

// Compares volume and rays at random points; returns how many points have casters before them.
int compare(const Triangles& mesh, const ShadowVolume& volume, const glm::dvec3& light,
            const std::function<double(const glm::dvec3&)>& weight, std::mt19937& random) {
  std::uniform_real_distribution<double> place(-6.0, 6.0);
  int shaded = 0, clear = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 point(place(random), place(random), place(random));
    const std::optional<double> expected = casters_before(mesh, point, light, weight);
    if (!expected) continue;
    ++clear;
    shaded += *expected > 0.0 ? 1 : 0;
    EXPECT_NEAR(times_inside(volume, point), *expected, 1e-3)
        << point.x << ", " << point.y << ", " << point.z;
  }
  EXPECT_GT(clear, 800);
  return shaded;
}

// The places are the same on every machine, which distributions of the standard library are not.
glm::vec3 random_place(std::mt19937& random, float size) {
  glm::vec3 place;
  for (int axis = 0; axis < 3; ++axis)
    place[axis] = size * (2.0F * static_cast<float>(random() >> 8U) * 0x1p-24F - 1.0F);
  return place;
}

glm::vec3 random_step(std::mt19937& random) {
  glm::vec3 place;
  for (int axis = 0; axis < 3; ++axis) place[axis] = static_cast<float>(random() % 5) - 2.0F;
  return place;
}

Triangles soup(std::mt19937& random, int count) {
  Triangles mesh;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 at = random_place(random, 4.0F);
    const glm::vec3 along = random_place(random, 3.0F), across = random_place(random, 3.0F);
    mesh.add(at, at + along, at + across);
  }
  return mesh;
}

TEST(ShadowVolume, OfABoxBeginsAtTheFacesTurnedAway) {
  Triangles mesh;
  mesh.add_box({-1, -1, -1}, {2, 3, 1});
  const glm::dvec3 light(0.3, -0.8, 0.5);
  const ShadowVolume volume = volume_of(mesh, light);
  EXPECT_EQ(volume.closed_pieces, 1U);
  EXPECT_EQ(volume.open_pieces, 0U);
  EXPECT_EQ(volume.caps, 6U);
  EXPECT_EQ(volume.walls, 6U);
  EXPECT_EQ(volume.indices.size(), 3 * (2 * volume.caps + 2 * volume.walls));
  EXPECT_EQ(volume.positions.size(), 14U) << "a corner of the box has lit faces alone";
  EXPECT_EQ(gaps(volume), 0U);
  EXPECT_NEAR(times_inside(volume, {0.5, 1.0, 0.0}), 0.0, 1e-6) << "the solid is not in it";
  EXPECT_NEAR(times_inside(volume, {0.5, -1.5, 0.0}), 1.0, 1e-6);
  EXPECT_NEAR(times_inside(volume, {0.5, 4.0, 0.0}), 0.0, 1e-6);
  for (std::size_t i = 0; i < 3 * volume.caps; i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(volume.positions[volume.indices[i + k]]); };
    EXPECT_LT(glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), light), 0.0) << "out of the volume";
  }
}

TEST(ShadowVolume, IsClosedAndRightForOpenTriangles) {
  std::mt19937 random(3);
  int shaded = 0;
  for (int round = 0; round < 8; ++round) {
    const Triangles mesh = soup(random, 30);
    const glm::dvec3 light(random_place(random, 1.0F));
    const ShadowVolume volume = volume_of(mesh, light);
    EXPECT_EQ(gaps(volume), 0U);
    EXPECT_EQ(volume.open_pieces, 30U);
    EXPECT_EQ(volume.caps, 30U);
    EXPECT_EQ(volume.walls, 90U);
    shaded += compare(mesh, volume, light, every_triangle, random);
  }
  EXPECT_GT(shaded, 1000);
}

// The triangles share vertices of a small grid: fans, folds, more than two at an edge, coincident ones, both
// windings, corners on others' edges, and faces along which the light passes exactly.
TEST(ShadowVolume, IsClosedAndRightForTrianglesOnAGrid) {
  std::mt19937 random(5);
  int dropped = 0;
  for (int round = 0; round < 8; ++round) {
    Triangles mesh;
    for (int i = 0; i < 60; ++i) {
      const glm::vec3 a = random_step(random), b = random_step(random), c = random_step(random);
      mesh.add(a, b, c);
    }
    for (const glm::dvec3 light :
         {glm::dvec3(0, -1, 0), glm::dvec3(1, -1, 0), glm::dvec3(0.31, -0.83, 0.47), glm::dvec3(-2, 0, 1)}) {
      const ShadowVolume volume = volume_of(mesh, light);
      EXPECT_EQ(gaps(volume), 0U);
      dropped += 60 - static_cast<int>(volume.caps);
      if (volume.closed_pieces > 0) continue;
      compare(mesh, volume, light, every_triangle, random);
    }
  }
  EXPECT_GT(dropped, 50);
}

// Closed pieces count once, by the triangles that are turned away.
TEST(ShadowVolume, OfClosedPiecesCountsTheSolidsBeforeAPoint) {
  std::mt19937 random(9);
  Triangles mesh;
  mesh.add_box({-3, 0, -3}, {-1, 2, -1});
  mesh.add_box({-1, 0, -1}, {1, 1, 1});  // it shares an edge's line and one corner with the first
  mesh.add_box({1, 0, -1}, {2, 1, 1});   // it shares a face
  mesh.add_box({-2, 4, -2}, {2, 4.5F, 2});
  const glm::dvec3 light(0.2, -0.9, -0.3);
  const ShadowVolume volume = volume_of(mesh, light);
  EXPECT_EQ(volume.open_pieces, 0U);
  EXPECT_EQ(volume.closed_pieces, 3U);
  EXPECT_EQ(gaps(volume), 0U);
  EXPECT_GT(compare(
                mesh, volume, light,
                [&](const glm::dvec3& normal) { return glm::dot(normal, light) > 0.0 ? 1.0 : 0.0; }, random),
            60);
}

// Four triangles at an edge cancel, three do not: one wall remains.
TEST(ShadowVolume, WallsStandWhereDirectedEdgesRemain) {
  const glm::vec3 low(0, 0, 0), high(0, 0, 1);
  const auto with = [&](int blades) {
    Triangles mesh;
    for (int i = 0; i < blades; ++i) {
      const glm::vec3 tip(i % 2 == 0 ? 1.0F : -1.0F, 0.1F * static_cast<float>(i), 0.5F);
      mesh.add(low, high, tip);
    }
    return volume_of(mesh, {0.0, -1.0, 0.0});
  };
  EXPECT_EQ(with(1).walls, 3U);
  EXPECT_EQ(with(2).walls, 4U) << "both face up, one to each side";
  EXPECT_EQ(with(3).walls, 7U);
  EXPECT_EQ(with(4).walls, 8U);
  for (int blades = 1; blades < 6; ++blades) EXPECT_EQ(gaps(with(blades)), 0U);
}

TEST(ShadowVolume, OfALeafWithTwoSidesIsThatOfOne) {
  Triangles one, both;
  one.add({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  both = one;
  both.add({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
  const ShadowVolume single = volume_of(one, {0.1, -1, 0.2}), twin = volume_of(both, {0.1, -1, 0.2});
  EXPECT_EQ(twin.closed_pieces, 1U);
  EXPECT_EQ(twin.caps, 1U);
  EXPECT_EQ(twin.walls, 3U);
  EXPECT_EQ(single.caps, 1U);
  for (const glm::dvec3 point : {glm::dvec3(0.2, -0.5, 0.2), glm::dvec3(0.2, 0.5, 0.2), glm::dvec3(3, -1, 1)})
    EXPECT_NEAR(times_inside(twin, point), times_inside(single, point), 1e-6);
}

TEST(ShadowVolume, TrianglesAlongTheLightCastNothing) {
  Triangles mesh;
  mesh.add({0, 0, 0}, {0, 1, 0}, {0, 0, 1});
  EXPECT_EQ(volume_of(mesh, {0, -1, 0}).indices.size(), 0U);
  EXPECT_EQ(volume_of(mesh, {0, -1, 1e-9}).caps, 0U) << "in the triangle's plane";
  EXPECT_EQ(volume_of(mesh, {1e-9, -1, 0}).caps, 1U);
}

TEST(ShadowVolume, TrianglesWithoutThreeCornersAreLeftOut) {
  Triangles mesh;
  mesh.add({0, 0, 0}, {0, 0, 0}, {1, 0, 0});
  mesh.add({0.0F, 1, 0}, {-0.0F, 1, 0}, {1, 0, 0});
  EXPECT_EQ(volume_of(mesh, {0, -1, 0}).indices.size(), 0U);
  EXPECT_EQ(volume_of(mesh, {0, -1, 0}).open_pieces, 0U);
  EXPECT_EQ(volume_of({}, {0, -1, 0}).positions.size(), 0U);
}

// One face of a closed box is cut at the middle of an edge that its neighbour is not.
TEST(ShadowVolume, AMeshWithATJunctionIsOpenAndItsVolumeClosed) {
  Triangles mesh;
  mesh.add_box({-1, -1, -1}, {1, 1, 1});
  mesh.indices.resize(mesh.indices.size() - 6);
  mesh.add({-1, -1, 1}, {1, -1, 1}, {0, 1, 1});
  mesh.add({1, -1, 1}, {1, 1, 1}, {0, 1, 1});
  mesh.add({-1, -1, 1}, {0, 1, 1}, {-1, 1, 1});
  std::mt19937 random(2);
  const glm::dvec3 light(0.4, -0.7, -0.2);
  const ShadowVolume volume = volume_of(mesh, light);
  EXPECT_EQ(volume.open_pieces, 1U);
  EXPECT_EQ(gaps(volume), 0U);
  EXPECT_GT(compare(mesh, volume, light, every_triangle, random), 5);
}

TEST(ShadowVolume, CapVerticesAreTheMeshsBits) {
  std::mt19937 random(4);
  const Triangles mesh = soup(random, 40);
  const ShadowVolume volume = volume_of(mesh, {0.3, -0.9, 0.1});
  std::set<std::tuple<float, float, float>> places;
  for (const glm::vec3& at : mesh.positions) places.emplace(at.x, at.y, at.z);
  ASSERT_EQ(volume.positions.size(), 2 * places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::vec3& at = volume.positions[i];
    EXPECT_EQ(places.count({at.x, at.y, at.z}), 1U);
    const glm::dvec3 moved = glm::dvec3(at) + kLength * glm::normalize(glm::dvec3(0.3, -0.9, 0.1));
    EXPECT_EQ(volume.positions[i + places.size()], glm::vec3(moved));
  }
}

TEST(ShadowVolume, OfHugeAndTinyTrianglesIsClosed) {
  for (const float size : {1e-30F, 1e-12F, 1e12F, 1e30F}) {
    Triangles mesh;
    mesh.add_box(glm::vec3(-size), glm::vec3(size));
    mesh.add({0, size, 0}, {size, size * 1.5F, 0}, {0, size, size});
    const ShadowVolume volume =
        shadow_volume(mesh.positions, mesh.indices, 4.0 * size * glm::dvec3(0.3, -0.9, 0.2));
    EXPECT_EQ(gaps(volume), 0U) << size;
  }
}

nlohmann::ordered_json numbers_of(const std::vector<glm::vec3>& positions) {
  nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
  for (const glm::vec3& at : positions)
    for (int axis = 0; axis < 3; ++axis) numbers.push_back(at[axis]);
  return numbers;
}

// The sample for Unity builds these volumes, too (tests/csharp/Samples).
std::string golden_text() {
  std::mt19937 random(11);
  Triangles boxes, leaves, grid;
  boxes.add_box({-3, 0, -3}, {-1, 2, -1});
  boxes.add_box({-1, 0, -1}, {1, 1.25F, 1});
  leaves.add({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  leaves.add({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
  leaves.add({0, 0, 0}, {0, 0, 1}, {-1, 0.25F, 0});
  leaves.add({2, 0, 0}, {2, -0.0F, 0}, {3, 0, 0});
  for (int i = 0; i < 20; ++i) {
    std::array<glm::vec3, 3> corners{};
    for (glm::vec3& corner : corners) corner = random_step(random);
    grid.add(corners[0], corners[1], corners[2]);
  }
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  for (const auto& [name, mesh] : std::vector<std::pair<std::string, Triangles>>{
           {"boxes", boxes}, {"leaves", leaves}, {"triangles on a grid", grid}, {"soup", soup(random, 12)}})
    for (const glm::dvec3 way : {glm::dvec3(6.25, -20.5, 3.0), glm::dvec3(0, -16, 0)}) {
      const ShadowVolume volume = shadow_volume(mesh.positions, mesh.indices, way);
      cases.push_back({{"name", name},
                       {"positions", numbers_of(mesh.positions)},
                       {"triangles", mesh.indices},
                       {"way", {way.x, way.y, way.z}},
                       {"volumePositions", numbers_of(volume.positions)},
                       {"volumeTriangles", volume.indices}});
    }
  return json_lines(nlohmann::ordered_json{{"cases", cases}}.dump());
}

TEST(ShadowVolume, OfTheGoldenFileAreTheSame) {
  const std::string text = golden_text();
  std::ostringstream checked_in;
  checked_in << std::ifstream(PENUMBRA_SOURCE_DIR "/tests/golden/shadow_volumes.json").rdbuf();
  const std::string now = testing::TempDir() + "shadow_volumes.json";
  std::ofstream(now) << text;
  EXPECT_TRUE(text == checked_in.str()) << "where this change is meant: cp " << now << " tests/golden/";
}

std::string refused(const std::function<void()>& work) {
  return input_error_of([&] { work(); });
}

TEST(ShadowVolume, RefusesWhatHasNone) {
  Triangles mesh;
  mesh.add({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  const auto with = [&](const std::function<void(Triangles&)>& edit, const glm::dvec3& way) {
    return refused([&] {
      Triangles edited = mesh;
      edit(edited);
      (void)shadow_volume(edited.positions, edited.indices, way);
    });
  };
  const auto as_it_is = [](Triangles&) {};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(with(as_it_is, {0, -1, 0}), "no error");
  EXPECT_THAT(with([&](Triangles& m) { m.positions[1].y = static_cast<float>(nan); }, {0, -1, 0}),
              HasSubstr("vertex 1 of a shadow volume is not finite"));
  EXPECT_THAT(with([&](Triangles& m) { m.positions[2].z = -infinity; }, {0, -1, 0}), HasSubstr("vertex 2"));
  EXPECT_EQ(with([&](Triangles& m) { m.positions.emplace_back(infinity); }, {0, -1, 0}), "no error")
      << "which no triangle has";
  EXPECT_THAT(with([](Triangles& m) { m.indices[2] = 3; }, {0, -1, 0}), HasSubstr("the index 3 of 3"));
  EXPECT_THAT(with([](Triangles& m) { m.indices.pop_back(); }, {0, -1, 0}), HasSubstr("2 indices"));
  EXPECT_THAT(with(as_it_is, {0, 0, 0}), HasSubstr("without a direction"));
  EXPECT_THAT(with(as_it_is, {nan, 1, 0}), HasSubstr("without a direction"));
  EXPECT_THAT(with(as_it_is, {0, -1e39, 0}), HasSubstr("range of a float"));
}

TEST(ShadowVolume, OfEveryBuiltInSceneIsClosedAndLeavesItsBounds) {
  for (const char* name : {"contact-boxes", "slabs", "street", "trees", "wires-and-smoke"}) {
    const Scene scene = built_in(name);
    const ShadowVolume volume = shadow_volume(scene);
    EXPECT_EQ(gaps(volume), 0U) << name;
    const parameters::Bounds bounds = scene.bounds();
    for (std::size_t i = volume.positions.size() / 2; i < volume.positions.size(); ++i) {
      const glm::dvec3 at(volume.positions[i]);
      const bool beyond =
          glm::any(glm::lessThan(at, bounds.minimum)) || glm::any(glm::greaterThan(at, bounds.maximum));
      ASSERT_TRUE(beyond) << name;
    }
    std::size_t blended = 0;
    for (std::size_t triangle = 0; triangle < scene.mesh.triangle_count(); ++triangle) {
      const auto& cut_out = scene.materials[scene.mesh.material_of(triangle)].cut_out;
      blended += cut_out && cut_out->mode == AlphaMode::blended ? 1 : 0;
    }
    EXPECT_GT(volume.caps, 0U);
    EXPECT_LE(volume.caps + blended, scene.mesh.triangle_count()) << name;
    EXPECT_EQ(blended > 0, std::string(name) == "wires-and-smoke");
  }
}

}  // namespace
}  // namespace penumbra::scene
