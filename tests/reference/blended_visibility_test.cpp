// Rays pass blended surfaces as often as their alphas say, alone and one behind the other, and the same ones
// pass whatever traces them.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/hand_built.h"
#include "reference/trace_visibility.h"

namespace penumbra::reference {
namespace {

using hand_built::mean;
using hand_built::Setting;

constexpr int kSide = 24;  // receivers
constexpr int kSamples = 256;
constexpr double kRays = double{kSide} * kSide * kSamples;

// Sheets of these alphas, each a metre above the one before, over all receivers.
scene::Scene sheets(const Setting& setting, const std::vector<float>& alphas) {
  scene::Scene scene;
  scene.name = "sheets";
  scene.materials.clear();
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    hand_built::add_rectangle(scene.mesh, setting, {-9, 9, -9, 9}, static_cast<double>(i) + 1.0);
    scene.materials.push_back(
        {.cut_out = scene::CutOut{.factor = alphas[i], .mode = scene::AlphaMode::blended}});
    scene.mesh.triangle_materials.insert(scene.mesh.triangle_materials.end(), 2,
                                         static_cast<std::uint16_t>(i));
  }
  return scene;
}

scene::Receivers receivers(const Setting& setting) {
  return hand_built::receivers(setting, {kSide, kSide},
                               [](int x, int y) { return glm::dvec2(0.05 * (x + 0.37), 0.05 * (y + 0.61)); });
}

// The interval of a share of independent rays, with which it holds in all but 1 of 16,000 draws.
double interval(double share) {
  return 4.0 * std::sqrt(share * (1.0 - share) / kRays);
}

class BlendedVisibility : public testing::TestWithParam<double> {
 protected:
  BlendedVisibility() { setting_.light.angular_diameter_degrees = GetParam(); }

  VisibilityImage traced(const scene::Scene& scene, int jobs = 0) const {
    RunOptions run;
    run.jobs = jobs;
    return trace_visibility(scene, receivers(setting_), setting_.light, {kSamples, 1}, run);
  }

  Setting setting_;
};

TEST_P(BlendedVisibility, OneSheetTransmitsOneLessItsAlpha) {
  for (const float alpha : {0.05F, 0.3F, 0.5F, 0.9F}) {
    const double seen = mean(traced(sheets(setting_, {alpha})));
    EXPECT_NEAR(seen, 1.0 - alpha, interval(alpha)) << alpha;
    EXPECT_NE(seen, 1.0) << alpha;
  }
  EXPECT_EQ(mean(traced(sheets(setting_, {0.0F}))), 1.0);
  EXPECT_EQ(mean(traced(sheets(setting_, {1.0F}))), 0.0);
}

TEST_P(BlendedVisibility, SheetsMultiply) {
  EXPECT_NEAR(mean(traced(sheets(setting_, {0.3F, 0.5F}))), 0.7 * 0.5, interval(0.35));
  EXPECT_NEAR(mean(traced(sheets(setting_, {0.2F, 0.4F, 0.1F}))), 0.8 * 0.6 * 0.9, interval(0.432));
  EXPECT_EQ(mean(traced(sheets(setting_, {0.3F, 1.0F}))), 0.0);
}

// The rays are independent: the halves' mean squared difference is that of two shares of half of the rays
// each.
TEST_P(BlendedVisibility, EveryReceiverAndRayIsDrawnForItself) {
  const VisibilityImage image = traced(sheets(setting_, {0.5F}));
  double squares = 0.0;
  for (const float visibility : image.visibility) squares += (visibility - 0.5) * (visibility - 0.5);
  EXPECT_NEAR(squares / (kSide * kSide), 0.25 / kSamples, 0.2 * 0.25 / kSamples);
}

TEST_P(BlendedVisibility, IsTheSameOnAnyNumberOfThreads) {
  const scene::Scene scene = sheets(setting_, {0.4F, 0.2F});
  const VisibilityImage one = traced(scene, 1);
  EXPECT_EQ(one.visibility, traced(scene, 2).visibility);
  EXPECT_EQ(one.visibility, traced(scene, 7).visibility);
}

TEST_P(BlendedVisibility, SmokeStopsWhatItsFormulaSays) {
  scene::Scene scene = sheets(setting_, {1.0F});
  scene.materials[0].cut_out->pattern = scene::AlphaPattern::smoke;
  // The puffs are 60 cm wide; the receivers are under two each way.
  const DiscLight disc = setting_.disc();
  for (const glm::vec3& position : scene.mesh.positions)
    scene.mesh.uvs.emplace_back(glm::dot(glm::dvec3(position), disc.right) / 0.6,
                                glm::dot(glm::dvec3(position), disc.up) / 0.6);
  const double through = 1.0 - std::numbers::pi / 20.0;
  EXPECT_NEAR(mean(traced(scene)), through, 0.003 + interval(through));
}

INSTANTIATE_TEST_SUITE_P(Light, BlendedVisibility, testing::Values(0.0, 0.53, 5.0), [](const auto& light) {
  return light.param == 0.0 ? "point" : light.param < 1.0 ? "sun" : "wide";
});

}  // namespace
}  // namespace penumbra::reference
