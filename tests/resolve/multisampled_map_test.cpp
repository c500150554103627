// Compares the passes of multisampled shadow maps (Shaders/PenumbraMultisampledMaps.shader) with the depths
// of a tilted sheet: the mean of what the samples of a texel hold, at the places where samples lie.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <glm/matrix.hpp>

#include "resolve/kept_runners.h"
#include "resolve/run_once.h"
#include "resolve/synthetic_frame.h"
#include "scene/scene.h"

namespace penumbra::resolve {
namespace {

constexpr int kMapSize = 64;
// The standard pattern of four samples, from the texel's centre.
constexpr std::array<std::array<double, 2>, 4> kSamples{
    {{-0.125, -0.375}, {0.375, -0.125}, {-0.375, 0.125}, {0.125, 0.375}}};

// The scene is one sheet, tilted, that ends within the map.
scene::Scene sheet() {
  scene::Scene scene;
  scene.name = "sheet";
  scene.light_direction = {0.0, -1.0, 0.2};
  scene.camera = scene::camera_looking({0.0, 2.0, -9.0}, {0.0, 0.5, 0.0});
  scene.shadow_distance_metres = 30.0;
  scene.materials.resize(1);
  for (const auto& corner : {std::array{-12.0F, -9.0F}, {9.0F, -12.0F}, {12.0F, 10.0F}, {-10.0F, 12.0F}}) {
    scene.mesh.positions.emplace_back(corner[0], 3.0F + 0.4F * corner[0] - 0.25F * corner[1], corner[1]);
    scene.mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
  }
  scene.mesh.indices = {0, 1, 2, 0, 2, 3};
  scene.mesh.triangle_materials.assign(2, 0);
  return scene;
}

class MultisampledMap : public testing::TestWithParam<bool> {
 protected:
  MultisampledMap() {
    scene::FrameSettings settings;
    settings.shadows.cascades = 1;
    settings.shadows.resolution = kMapSize;
    settings.shadows.distance_metres = scene_.shadow_distance_metres;
    settings.shadows.depth_bias = settings.shadows.normal_bias = 0.0;
    settings.shadows.reversed_z = GetParam();
    settings.width = settings.height = kMapSize;
    frame_ = scene::rasterise(test_device(), scene_, settings);
    testing_frames::choose_cascade(frame_.cascades, 0);
    for (int y = 0; y < kMapSize; ++y)
      for (int x = 0; x < kMapSize; ++x) {
        const glm::dvec4 shadow((x + 0.5) / kMapSize, (y + 0.5) / kMapSize, 0.5, 1.0);
        const glm::dvec3 at(glm::inverse(to_shadow()) * shadow);
        frame_.receivers.position_ws[static_cast<std::size_t>(y * kMapSize + x)] =
            glm::vec4(glm::vec3(at), 1.0F);
        frame_.receivers.normal_ws[static_cast<std::size_t>(y * kMapSize + x)] = {0.0F, 1.0F, 0.0F, 0.0F};
      }
  }

  const glm::dmat4& to_shadow() const { return frame_.cascades.cascades[0].world_to_shadow; }

  std::vector<float> read(const char* technique) const {
    const techniques::TechniqueList list =
        techniques::read_technique_list(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests" / "resolve" /
                                        "samples" / "ReadMoments.technique.json");
    GraphRunner runner(test_device(),
                       compile(technique_graph(list, list.find(technique), Taps::as_listed, GetParam())));
    const CastersOnDevice casters(test_device(), scene_);
    return runner.run(FrameOnDevice(test_device(), frame_, &casters), kOnce).visibility[0];
  }

  // A corner of the sheet: place in the map in texels, and stored depth.
  glm::dvec3 corner(std::size_t i) const {
    return glm::dvec3(to_shadow() * glm::dvec4(glm::dvec3(scene_.mesh.positions[i % 4]), 1.0)) *
           glm::dvec3(kMapSize, kMapSize, 1.0);
  }

  // The depth of the sheet's plane, from the light, centred, at a place in texels.
  double plane_at(double x, double y) const {
    const glm::dvec3 first = corner(0);
    const glm::dvec2 across(corner(1) - first), along(corner(2) - first),
        p = glm::dvec2(x, y) - glm::dvec2(first);
    const double area = across.x * along.y - across.y * along.x;
    const double v = (p.x * along.y - p.y * along.x) / area, w = (across.x * p.y - across.y * p.x) / area;
    const double stored = first.z + v * (corner(1).z - first.z) + w * (corner(2).z - first.z);
    return (GetParam() ? 1.0 - stored : stored) - 0.5;
  }

  // The distance of a place inside of the sheet's edges, in texels; negative outside.
  double margin_at(double x, double y) const {
    const glm::dvec2 across(corner(1) - corner(0)), along(corner(2) - corner(0));
    const double turn = across.x * along.y - across.y * along.x > 0.0 ? 1.0 : -1.0;
    double inside = HUGE_VAL;
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec2 from(corner(i)), edge = glm::dvec2(corner(i + 1)) - from;
      inside = std::min(inside, turn * (edge.x * (y - from.y) - edge.y * (x - from.x)) / glm::length(edge));
    }
    return inside;
  }

  const scene::Scene scene_ = sheet();
  scene::Frame frame_;
};

// The rasteriser's bias moves each sample by the same amount: 2.5 times the larger slope, and one step.
TEST_P(MultisampledMap, ATexelHoldsTheMeansOfItsSamples) {
  const std::vector<float> means = read("mean"), squares = read("square");
  const double slope = std::max(std::abs(plane_at(1.0, 0.0) - plane_at(0.0, 0.0)),
                                std::abs(plane_at(0.0, 1.0) - plane_at(0.0, 0.0)));
  const double bias = 2.5 * slope;
  const double snapped = slope / 256.0;  // devices round vertices to a 256th of a texel
  int whole = 0, parted = 0;
  for (int y = 0; y < kMapSize; ++y)
    for (int x = 0; x < kMapSize; ++x) {
      double mean = 0.0, square = 0.0, nearest = HUGE_VAL;
      int covered = 0;
      for (const auto& sample : kSamples) {
        const double margin = margin_at(x + 0.5 + sample[0], y + 0.5 + sample[1]);
        const double depth = margin < 0.0 ? 0.5 : plane_at(x + 0.5 + sample[0], y + 0.5 + sample[1]) + bias;
        nearest = std::min(nearest, std::abs(margin));
        covered += margin >= 0.0 ? 1 : 0;
        mean += depth / 4.0;
        square += depth * depth / 4.0;
      }
      if (nearest < 0.02) continue;  // the rasteriser decides on which side of the edge the sample lies
      (covered == 4 ? whole : parted) += covered > 0 ? 1 : 0;
      const auto at = static_cast<std::size_t>(y * kMapSize + x);
      ASSERT_NEAR(means[at], 0.5 + mean, snapped) << x << ", " << y << ", slope " << slope;
      ASSERT_NEAR(squares[at], 0.5 + square, snapped) << x << ", " << y;
    }
  EXPECT_GT(whole, 300);
  EXPECT_GT(parted, 40);
}

INSTANTIATE_TEST_SUITE_P(Depth, MultisampledMap, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
