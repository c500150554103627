// Compares the technique shadow-volume with one ray to the sun's centre for each pixel: not one pixel differs
// where the rays of the pixel's surroundings agree.
#include <gmock/gmock.h>

#include <array>
#include <glm/geometric.hpp>
#include <random>

#include "as_identifier.h"
#include "reference/trace_visibility.h"
#include "resolve/graph_runner.h"
#include "resolve/run_once.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {
namespace {

// The slope of the light over the receiver: below this, the surface is nearly along the light.
constexpr double kLeastSlope = 0.02;
// So many pixels that differ are looked at again; those beyond count as differing.
constexpr int kMostAtEdges = 30;
// The share of a pixel by which the surroundings are moved to each side.
constexpr double kNear = 0.25;

struct Seen {
  scene::Frame frame;
  reference::VisibilityImage rays;
};

struct Differences {
  int lit = 0;       // pixels that are compared and lit
  int shaded = 0;    // the same in shadow
  int away = 0;      // pixels whose surface is turned away from the light, which casts that shadow itself
  int at_edges = 0;  // pixels that differ where only a closer look finds an edge within a quarter of a pixel
  int differing = 0;
};

scene::FrameSettings settings_of(const scene::Scene& scene, bool reversed_z) {
  scene::FrameSettings settings;
  settings.shadows.cascades = 1;
  settings.shadows.resolution = 256;
  settings.shadows.reversed_z = reversed_z;
  settings.shadows.distance_metres = scene.shadow_distance_metres;
  settings.width = 320;
  settings.height = 180;
  return settings;
}

Seen seen_of(const scene::Scene& scene, scene::Rasteriser& rasteriser, const scene::FrameSettings& settings) {
  scene::Frame frame = rasteriser.frame(settings);
  reference::VisibilityImage rays =
      reference::trace_visibility(scene, frame.receivers, parameters::Light{scene.light_direction, 0.0});
  return {std::move(frame), std::move(rays)};
}

GraphResult drawn_with_volumes(const scene::Scene& scene, const scene::Frame& frame, RowOrder rows) {
  CastersOnDevice casters(test_device(), scene);
  casters.add_volumes(test_device(), scene);
  GraphRunner runner(test_device(),
                     compile(technique_graph(library_techniques(), library_techniques().find("shadow-volume"),
                                             Taps::as_listed, frame.settings.shadows.reversed_z)));
  const CameraImage camera = camera_image(frame, rows);
  return runner.run(FrameOnDevice(test_device(), frame, &casters), &camera, kCountedOnce);
}

// Whether rays from a dense grid between the four surroundings agree. The five rays of a pixel may miss
// things such as a leaf's tip.
bool agreed_between(const scene::Scene& scene, const std::vector<Seen>& seen, std::size_t pixel) {
  constexpr int kAcross = 65;
  scene::Receivers grid;
  grid.width = grid.height = kAcross;
  const auto corner = [&](std::size_t i) {
    return glm::dvec3(seen[i].frame.receivers.position_relative[pixel]);
  };
  for (int row = 0; row < kAcross; ++row)
    for (int column = 0; column < kAcross; ++column) {
      const double x = column / (kAcross - 1.0), y = row / (kAcross - 1.0);
      const glm::dvec3 place =
          (1.0 - y) * ((1.0 - x) * corner(1) + x * corner(2)) + y * ((1.0 - x) * corner(3) + x * corner(4));
      grid.position_ws.emplace_back(glm::vec3(place), 1.0F);
      grid.normal_ws.push_back(seen.front().frame.receivers.normal_ws[pixel]);
      grid.triangle.push_back(seen.front().frame.receivers.triangle[pixel]);
    }
  grid.position_relative = grid.position_ws;
  const std::vector<float> rays =
      reference::trace_visibility(scene, grid, parameters::Light{scene.light_direction, 0.0}).visibility;
  return std::all_of(rays.begin(), rays.end(), [&](float ray) { return ray == rays.front(); });
}

// A pixel is compared where it and its four surroundings see one triangle and agree on its light.
Differences differences(const scene::Scene& scene, bool reversed_z = true,
                        RowOrder rows = RowOrder::top_first) {
  scene::Rasteriser rasteriser(test_device(), scene);
  const scene::FrameSettings settings = settings_of(scene, reversed_z);
  std::vector<Seen> seen{seen_of(scene, rasteriser, settings)};
  for (const glm::dvec2 side : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1)}) {
    scene::FrameSettings moved = settings;
    moved.lens_shift = 2.0 * kNear * side / glm::dvec2(settings.width, settings.height);
    seen.push_back(seen_of(scene, rasteriser, moved));
  }
  const GraphResult result = drawn_with_volumes(scene, seen.front().frame, rows);
  EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
  const scene::Receivers& receivers = seen.front().frame.receivers;
  const glm::dvec3 to_light = -glm::normalize(scene.light_direction);
  Differences found;
  for (std::size_t pixel = 0; pixel < receivers.position_ws.size(); ++pixel) {
    const float visibility = result.visibility[0][pixel];
    EXPECT_TRUE(visibility == 0.0F || visibility == 1.0F);
    const bool same_surface = std::all_of(seen.begin(), seen.end(), [&](const Seen& one) {
      return one.frame.receivers.triangle[pixel] == receivers.triangle[pixel];
    });
    if (!same_surface || receivers.position_ws[pixel].w == 0.0F) continue;
    const double slope = glm::dot(glm::dvec3(receivers.normal_ws[pixel]), to_light);
    if (std::abs(slope) < kLeastSlope) continue;
    const bool turned_away = slope < 0.0;
    const bool agreed = std::all_of(seen.begin(), seen.end(), [&](const Seen& one) {
      return one.rays.visibility[pixel] == seen.front().rays.visibility[pixel];
    });
    if (!turned_away && !agreed) continue;
    const float expected = turned_away ? 0.0F : seen.front().rays.visibility[pixel];
    ++(turned_away ? found.away : expected == 1.0F ? found.lit : found.shaded);
    if (visibility == expected) continue;
    if (!turned_away && found.at_edges < kMostAtEdges && !agreed_between(scene, seen, pixel)) {
      ++found.at_edges;
      continue;
    }
    ++found.differing;
    const auto width = static_cast<std::size_t>(receivers.width);
    if (found.differing <= 5)
      ADD_FAILURE() << scene.name << ": pixel " << pixel % width << ", " << pixel / width << " of triangle "
                    << receivers.triangle[pixel] << " has " << visibility << ", slope " << slope;
  }
  return found;
}

// The scene has no holes, because volumes cast whole triangles.
scene::Scene without_holes(scene::Scene scene) {
  for (scene::Material& material : scene.materials) material.cut_out.reset();
  return scene;
}

class VolumesOf : public testing::TestWithParam<std::string> {};

TEST_P(VolumesOf, BuiltInScenesAreWhatRaysSay) {
  const Differences found = differences(without_holes(scene::built_in(GetParam())));
  EXPECT_EQ(found.differing, 0);
  EXPECT_GT(found.lit, 2000);
  EXPECT_GT(found.shaded, 800);
}

INSTANTIATE_TEST_SUITE_P(Scenes, VolumesOf,
                         testing::Values("contact-boxes", "slabs", "street", "trees", "colonnade",
                                         "poles-and-fence"),
                         [](const auto& instance) { return as_identifier(instance.param); });

TEST(ShadowVolumeTechnique, DepthOfEitherDirectionAndRowsOfEitherOrderAreTheSame) {
  const scene::Scene scene = scene::built_in("contact-boxes");
  EXPECT_EQ(differences(scene, false).differing, 0);
  EXPECT_EQ(differences(scene, true, RowOrder::bottom_first).differing, 0);
}

// Whether a ray from there to the sun is stopped.
bool in_shadow(const scene::Scene& scene, const glm::dvec3& place) {
  scene::Receivers one;
  one.width = one.height = 1;
  one.position_ws = one.position_relative = {glm::vec4(glm::vec3(place), 1.0F)};
  one.normal_ws = {glm::vec4(glm::vec3(-glm::normalize(scene.light_direction)), 0.0F)};
  one.triangle = {0};
  return reference::trace_visibility(scene, one, parameters::Light{scene.light_direction, 0.0})
             .visibility[0] == 0.0F;
}

TEST(ShadowVolumeTechnique, TheCameraMayBeInAShadow) {
  scene::Scene scene = scene::built_in("slabs");
  const glm::dvec3 target = scene.camera.position + 12.0 * scene.camera.forward;
  int tried = 0, compared = 0;
  for (double x = -6.0; x <= 6.0 && tried < 4; x += 0.9)
    for (double z = 2.0; z <= 14.0 && tried < 4; z += 2.3) {
      const glm::dvec3 place(x, 0.3, z);
      if (!in_shadow(scene, place)) continue;
      ++tried;
      scene.camera = scene::camera_looking(place, {target.x, 0.4, target.z + 6.0});
      const Differences found = differences(scene);
      EXPECT_EQ(found.differing, 0);
      compared += std::min(found.lit, found.shaded);
    }
  EXPECT_EQ(tried, 4);
  EXPECT_GT(compared, 1000);
}

// The triangles are open and random: single ones, fans around a common edge, and pairs of one place.
scene::Scene random_triangles(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  const auto place = [&](float size) {
    const float x = unit(random), y = unit(random), z = unit(random);
    return size * glm::vec3(x, y, z);
  };
  scene::Scene scene;
  scene.name = "random triangles";
  scene.origin = {30.0, -2.0, 55.0};
  scene.light_direction = scene::sunlight(40.0 + 15.0 * seed, 70.0 * seed);
  scene.camera = scene::camera_looking({0.0, 3.0, -9.0}, {0.0, 1.5, 0.0});
  const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (const glm::vec3& corner : {a, b, c}) {
      scene.mesh.indices.push_back(static_cast<std::uint32_t>(scene.mesh.positions.size()));
      scene.mesh.positions.push_back(corner);
      scene.mesh.normals.push_back(normal);
    }
  };
  add({-20, 0, -12}, {-20, 0, 20}, {20, 0, -12});
  add({20, 0, -12}, {-20, 0, 20}, {20, 0, 20});
  for (int i = 0; i < 60; ++i) {
    const glm::vec3 at = glm::vec3(0.0F, 2.6F, 1.0F) + place(2.4F) * glm::vec3(2.0F, 1.0F, 1.5F);
    const glm::vec3 along = place(0.9F);
    for (int blade = 0; blade < 1 + i % 4; ++blade) add(at, at + along, at + place(1.2F));
    if (i % 5 != 0) continue;
    const glm::vec3 tip = at + place(1.0F);
    add(at, at + along, tip);
    add(at, tip, at + along);
  }
  return scene;
}

TEST(ShadowVolumeTechnique, OpenTrianglesAtRandomAreWhatRaysSay) {
  Differences all;
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Differences found = differences(random_triangles(seed));
    all.lit += found.lit;
    all.shaded += found.shaded;
    all.away += found.away;
    all.differing += found.differing;
  }
  EXPECT_EQ(all.differing, 0);
  EXPECT_GT(all.lit, 20000);
  EXPECT_GT(all.shaded, 10000);
  EXPECT_GT(all.away, 5000);
}

TEST(ShadowVolumeTechnique, ReadsNoTextures) {
  const scene::Scene scene = scene::built_in("contact-boxes");
  scene::Rasteriser rasteriser(test_device(), scene);
  const GraphResult result =
      drawn_with_volumes(scene, rasteriser.frame(settings_of(scene, true)), RowOrder::top_first);
  std::vector<std::string> passes;
  for (const PassCounts& pass : result.passes) {
    passes.push_back(pass.pass);
    EXPECT_EQ(pass.fetches, 0.0);
  }
  EXPECT_THAT(passes, testing::ElementsAre("SceneDepth", "CountVolumes", "VolumeVisibility"));
  EXPECT_THAT(result.fetches, testing::Each(0U));
}

TEST(ShadowVolumeTechnique, VolumesHaveToBeThere) {
  const scene::Scene scene = scene::built_in("contact-boxes");
  scene::Rasteriser rasteriser(test_device(), scene);
  const CastersOnDevice casters(test_device(), scene);
  const scene::Frame frame = rasteriser.frame(settings_of(scene, true));
  GraphRunner runner(test_device(), compile(technique_graph(library_techniques(),
                                                            library_techniques().find("shadow-volume"))));
  const CameraImage camera = camera_image(frame);
  EXPECT_THROW(runner.run(FrameOnDevice(test_device(), frame, &casters), &camera), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::resolve
