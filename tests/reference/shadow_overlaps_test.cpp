// Receivers under a low and a high rectangle: the overlap is where both hide a part of the disc and their
// gaps differ fourfold.
#include "reference/shadow_overlaps.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "reference/hand_built.h"
#include "reference/trace_visibility.h"

namespace penumbra::reference {
namespace {

using hand_built::Setting;

constexpr ImageSize kSize{64, 4};
constexpr double kLow = 1.0;

// The receivers lie 4 m across. The low rectangle hides what is left of 0.5, the high one what is right of
// -0.5.
std::vector<std::uint8_t> overlaps_below(double high, const Setting& setting, int jobs = 0) {
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, setting, {-40.0, 0.5, -40.0, 40.0}, kLow);
  hand_built::add_rectangle(scene.mesh, setting, {-0.5, 40.0, -40.0, 40.0}, high);
  const scene::Receivers receivers = hand_built::receivers(
      setting, kSize, [](int x, int y) { return glm::dvec2(4.0 * (x + 0.5) / kSize.width - 2.0, 0.1 * y); });
  TraceOptions options;
  options.samples = 256;
  const VisibilityImage visibility = trace_visibility(scene, receivers, setting.light, options);
  return shadow_overlaps(scene, receivers, setting.light, visibility, jobs);
}

TEST(ShadowOverlaps, AreWhereBothCastersHideTheDisc) {
  const Setting setting;
  for (const double high : {kOverlapRatio * kLow + 0.1, 8.0, 30.0}) {
    const std::vector<std::uint8_t> overlaps = overlaps_below(high, setting);
    // Between the shadows' inner edges all rays meet both; a disc's radius beyond the outer ones none do.
    const double low_radius = kLow * setting.tan_half();
    const double high_radius = high * setting.tan_half();
    for (int x = 0; x < kSize.width; ++x) {
      const double across = 4.0 * (x + 0.5) / kSize.width - 2.0;
      const bool surely = across < 0.5 - low_radius && across > -0.5 + high_radius;
      const bool surely_not = across > 0.5 + low_radius || across < -0.5 - high_radius;
      if (surely || surely_not) {
        EXPECT_EQ(overlaps[static_cast<std::size_t>(x)], surely ? 1 : 0) << high << ", " << across;
      }
    }
  }
}

TEST(ShadowOverlaps, AreNoneWhereGapsDiffLess) {
  for (const std::uint8_t overlap : overlaps_below(kOverlapRatio * kLow - 0.2, {})) EXPECT_EQ(overlap, 0);
}

TEST(ShadowOverlaps, AreTheSameWithAnyNumberOfThreads) {
  EXPECT_EQ(overlaps_below(8.0, {}, 1), overlaps_below(8.0, {}, 3));
}

TEST(ShadowOverlaps, PicturesOfTwoSizesAreRefused) {
  const Setting setting;
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, setting, {-1.0, 1.0, -1.0, 1.0}, kLow);
  const auto at = [](int, int) { return glm::dvec2(0.0); };
  const VisibilityImage small =
      trace_visibility(scene, hand_built::receivers(setting, {8, 2}, at), setting.light, {});
  EXPECT_THROW((void)shadow_overlaps(scene, hand_built::receivers(setting, {8, 4}, at), setting.light, small),
               std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::reference
