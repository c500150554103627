// The ray-traced answer and the same-map estimate share no code past the receivers: where geometry is made of
// whole texels at exact depths, they must be one picture.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "reference/hand_built.h"
#include "reference/same_map_estimate.h"
#include "reference/trace_visibility.h"

namespace penumbra::reference {
namespace {

using hand_built::Map;
using hand_built::Setting;

// disc_light chooses axes of its own and the map here uses the same, so texels are squares in both.
struct Blocks {
  scene::Scene scene;
  Map map;

  explicit Blocks(const Setting& setting, const glm::dvec3& origin, bool reversed_z) {
    map = hand_built::empty_map(setting, {.reversed_z = reversed_z}, origin);
    std::uint32_t state = 7;
    for (int row = 0; row < 64; ++row) {
      for (int column = 0; column < 64; ++column) {
        state = state * 1664525U + 1013904223U;
        if ((state >> 28) < 10) continue;  // three eighths of the texels block, at 1, 2 .. 8 m
        const double gap = 1.0 + (state >> 20) % 8;
        map.set_gap(column, row, gap);
        const double left = 0.1 * column - 3.2;
        const double bottom = 0.1 * row - 3.2;
        hand_built::add_rectangle(scene.mesh, setting, {left, left + 0.1, bottom, bottom + 0.1}, gap);
      }
    }
  }
};

void expect_agreement(const Setting& setting, const glm::dvec3& origin, bool reversed_z) {
  const Blocks blocks(setting, origin, reversed_z);
  const scene::Receivers receivers = hand_built::receivers(
      setting, {40, 40}, [](int x, int y) { return glm::dvec2(0.061 * x - 1.2, 0.059 * y - 1.2); });
  const VisibilityImage traced = trace_visibility(blocks.scene, receivers, setting.light, {4096, 1});
  const VisibilityImage estimate =
      same_map_estimate({blocks.map.atlas, blocks.map.cascades, receivers, origin});
  double squares = 0.0;
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < traced.visibility.size(); ++pixel) {
    const double difference = estimate.visibility[pixel] - traced.visibility[pixel];
    squares += difference * difference;
    sum += difference;
    EXPECT_NEAR(difference, 0.0, 0.05) << "pixel " << pixel;
  }
  const double pixels = static_cast<double>(traced.visibility.size());
  const double expected = std::hypot(traced.noise_floor, estimate.noise_floor);
  EXPECT_LT(std::sqrt(squares / pixels), 1.2 * expected);
  EXPECT_NEAR(sum / pixels, 0.0, 0.2 * expected) << "no bias";
  EXPECT_LT(expected, 0.02);
}

TEST(Agreement, OfRayTracingAndSameMapOnWholeTexels) {
  for (const bool reversed_z : {false, true}) expect_agreement(Setting{}, glm::dvec3(0.0), reversed_z);
}

TEST(Agreement, HoldsUnderALowSun) {
  Setting setting;
  setting.light = {{0.97, -0.1, 0.2}, 2.0};
  expect_agreement(setting, glm::dvec3(0.0), true);
}

TEST(Agreement, HoldsFarFromTheOrigin) {
  expect_agreement(Setting{}, glm::dvec3(1e5, -3e4, 7e4), true);
}

TEST(Agreement, MovingTheWorldChangesNoMoreThanRoundingOfTheMatrix) {
  const Setting setting;
  const scene::Receivers receivers = hand_built::receivers(
      setting, {40, 40}, [](int x, int y) { return glm::dvec2(0.061 * x - 1.2, 0.059 * y - 1.2); });
  const Blocks here(setting, glm::dvec3(0.0), true);
  const glm::dvec3 origin(1e5, -3e4, 7e4);
  const Blocks there(setting, origin, true);
  const VisibilityImage at_home = same_map_estimate({here.map.atlas, here.map.cascades, receivers});
  const VisibilityImage far_off = same_map_estimate({there.map.atlas, there.map.cascades, receivers, origin});
  for (std::size_t pixel = 0; pixel < at_home.visibility.size(); ++pixel) {
    EXPECT_NEAR(far_off.visibility[pixel], at_home.visibility[pixel], 2.0 / 1024.0);
  }
}

}  // namespace
}  // namespace penumbra::reference
