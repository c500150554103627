// Rays pass cut-outs as often as the pattern says, and are those that pass the same holes between triangles.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "input/input_error.h"
#include "reference/hand_built.h"
#include "reference/reference_cache.h"
#include "reference/scratch_folder.h"
#include "reference/trace_visibility.h"

namespace penumbra::reference {
namespace {

using hand_built::mean;
using hand_built::Setting;

constexpr double card_gap = 2.0;
constexpr double cell_metres = 0.25;  // metres per square of the pattern
constexpr int card_cells = 8;         // squares along the card's edge

// A card of 2 m with coordinates 0 .. 8, centred over the receivers.
scene::Scene card(const Setting& setting, const scene::CutOut& cut_out) {
  scene::Scene scene;
  scene.name = "card";
  constexpr double half = 0.5 * card_cells * cell_metres;
  hand_built::add_rectangle(scene.mesh, setting, {-half, half, -half, half}, card_gap);
  const DiscLight disc = setting.disc();
  for (const glm::vec3& position : scene.mesh.positions) {
    const glm::dvec3 from_centre = glm::dvec3(position) - setting.centre;
    scene.mesh.uvs.emplace_back((glm::dot(from_centre, disc.right) + half) / cell_metres,
                                (glm::dot(from_centre, disc.up) + half) / cell_metres);
  }
  scene::Material material;
  material.cut_out = cut_out;
  scene.materials = {material};
  return scene;
}

// Receivers, `side` squared of them over `extent` metres about the centre, none over an edge of the pattern.
scene::Receivers under(const Setting& setting, int side, double extent) {
  return hand_built::receivers(setting, {side, side}, [=](int x, int y) {
    return glm::dvec2(extent * ((x + 0.5) / side - 0.5), extent * ((y + 0.5) / side - 0.5));
  });
}

// There are 32 receivers a square, so that the wires' edges at 1/16 and 15/16 lie between them.
TEST(CutOutVisibility, APointLightPassesTheOpenShareOfAFence) {
  Setting setting;
  setting.light.angular_diameter_degrees = 0.0;
  const scene::Receivers receivers = under(setting, 128, 4 * cell_metres);
  const VisibilityImage fence =
      trace_visibility(card(setting, {.pattern = scene::AlphaPattern::wire_grid}), receivers, setting.light);
  EXPECT_EQ(mean(fence), 49.0 / 64.0);
}

TEST(CutOutVisibility, ATinyLightPassesTheOpenShareOfEachPattern) {
  Setting setting;
  setting.light.angular_diameter_degrees = 0.05;  // the disc is 1.7 mm at this gap, 1/140 of a square
  const scene::Receivers receivers = under(setting, 128, 4 * cell_metres);
  const auto visible = [&](const scene::CutOut& cut_out) {
    return mean(trace_visibility(card(setting, cut_out), receivers, setting.light, {64, 1}));
  };
  EXPECT_NEAR(visible({.pattern = scene::AlphaPattern::wire_grid}), 49.0 / 64.0, 0.002);
  EXPECT_NEAR(visible({.pattern = scene::AlphaPattern::holes}), 9.0 * std::numbers::pi / 64.0, 0.004);
  EXPECT_NEAR(visible({.pattern = scene::AlphaPattern::leaf}), 2.0 / 3.0, 0.004);
  EXPECT_EQ(visible({.factor = 0.4F}), 1.0);
  EXPECT_EQ(visible({.factor = 0.6F}), 0.0);
}

// The holes of a fence are gaps between rectangles: the rays are the same, and so must be what they meet.
TEST(CutOutVisibility, AFenceOfTrianglesPassesTheSameRays) {
  for (const double degrees : {0.5, 5.0}) {
    Setting setting;
    setting.light.angular_diameter_degrees = degrees;
    scene::Scene wires;
    constexpr double half = 0.5 * card_cells * cell_metres, thin = cell_metres / 16.0;
    for (int wire = 0; wire <= card_cells; ++wire) {
      const double at = wire * cell_metres - half;
      const double low = std::max(at - thin, -half), high = std::min(at + thin, half);
      hand_built::add_rectangle(wires.mesh, setting, {low, high, -half, half}, card_gap);
      hand_built::add_rectangle(wires.mesh, setting, {-half, half, low, high}, card_gap);
    }
    const scene::Receivers receivers = under(setting, 61, 1.5);
    const VisibilityImage solid = trace_visibility(wires, receivers, setting.light, {256, 1});
    const VisibilityImage cut = trace_visibility(card(setting, {.pattern = scene::AlphaPattern::wire_grid}),
                                                 receivers, setting.light, {256, 1});
    int rays_apart = 0;
    for (std::size_t pixel = 0; pixel < solid.visibility.size(); ++pixel) {
      rays_apart +=
          static_cast<int>(std::lround(256.0F * std::abs(solid.visibility[pixel] - cut.visibility[pixel])));
    }
    // There are 952,576 rays; those within a float's rounding of an edge may go either way.
    EXPECT_LT(rays_apart, 40) << degrees << " degrees";
    EXPECT_GT(mean(cut), 0.5);
    EXPECT_LT(mean(cut), 0.9);
  }
}

TEST(CutOutVisibility, SolidTrianglesBesideCutOutsStillBlock) {
  const Setting setting;
  scene::Scene scene = card(setting, {.factor = 0.0F});
  scene.mesh.triangle_materials = {0, 0};
  EXPECT_EQ(mean(trace_visibility(scene, under(setting, 4, 0.5), setting.light)), 1.0);
  scene.materials.emplace_back();
  hand_built::add_rectangle(scene.mesh, setting, {-9, 9, -9, 9}, 2.0 * card_gap);
  scene.mesh.triangle_materials = {0, 0, 1, 1};
  EXPECT_EQ(mean(trace_visibility(scene, under(setting, 4, 0.5), setting.light)), 0.0);
  scene.mesh.triangle_materials = {1, 0, 0, 0};
  const EmbreeScene embree(scene);
  EXPECT_EQ(embree.triangle(0, 0), 0U);
  EXPECT_EQ(embree.triangle(1, 0), 1U);
  EXPECT_EQ(embree.triangle(1, 2), 3U);
}

TEST(CutOutVisibility, IsKeptUnderANameOfItsOwn) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  const Setting setting;
  const scene::Receivers receivers = under(setting, 8, 0.5);
  scene::Scene scene = card(setting, {.pattern = scene::AlphaPattern::wire_grid});
  const auto visible = [&] {
    return mean(trace_visibility(scene, receivers, setting.light, {}, {}, &cache));
  };
  const double fence = visible();
  scene.materials[0].cut_out->cutoff = 0.9F;
  EXPECT_GT(visible(), fence);
  scene.materials[0].cut_out.reset();
  EXPECT_LT(visible(), fence);
}

TEST(CutOutVisibility, BrokenCutOutsAreRefused) {
  const Setting setting;
  scene::Scene scene = card(setting, {.pattern = scene::AlphaPattern::leaf});
  scene.mesh.uvs.clear();
  EXPECT_THROW(trace_visibility(scene, under(setting, 4, 0.5), setting.light), InputError);
}

}  // namespace
}  // namespace penumbra::reference
