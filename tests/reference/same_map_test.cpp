#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "input/input_error.h"
#include "reference/hand_built.h"
#include "reference/same_map_estimate.h"

namespace penumbra::reference {
namespace {

using hand_built::Map;
using hand_built::MapSettings;
using hand_built::Setting;

constexpr double edge_gap = 3.0;
// Bound for one rectangle or half-plane: reference/disc_coverage.h.
constexpr double resolution_bound = 0.008;

scene::Receivers line(const Setting& setting, double half_length) {
  return hand_built::receivers(setting, {64, 1}, [=](int x, int) {
    return glm::dvec2(half_length * (2.0 * (x + 0.5) / 64.0 - 1.0), 0.003);
  });
}

// Blocks the texels left of the middle column at this edge_gap.
void block_left_half(Map& map, double gap_metres) {
  for (int row = 0; row < map.atlas.height; ++row) {
    for (int column = 0; column < map.atlas.width / 2; ++column) map.set_gap(column, row, gap_metres);
  }
}

TEST(SameMap, TexelAlignedEdgeIsTheCircularSegmentInBothDepthDirections) {
  for (const bool reversed_z : {false, true}) {
    for (const scene::DepthFormat format : {scene::DepthFormat::d16, scene::DepthFormat::d32}) {
      const Setting setting;
      const double tan_half = setting.tan_half();
      MapSettings settings;
      settings.reversed_z = reversed_z;
      settings.format = format;
      Map map = hand_built::empty_map(setting, settings);
      block_left_half(map, edge_gap);
      const scene::Receivers receivers = line(setting, 1.2 * edge_gap * tan_half);
      const VisibilityImage image = same_map_estimate({map.atlas, map.cascades, receivers});
      for (int x = 0; x < 64; ++x) {
        const double distance = 1.2 * edge_gap * tan_half * (2.0 * (x + 0.5) / 64.0 - 1.0);
        EXPECT_NEAR(image.visibility[static_cast<std::size_t>(x)],
                    hand_built::visible_past_edge(distance, edge_gap, tan_half), resolution_bound)
            << "pixel " << x << (reversed_z ? ", reversed" : ", conventional");
      }
    }
  }
}

TEST(SameMap, LayersThatOverlapCountOnce) {
  // A second layer, farther and wholly behind the first as seen from the receiver, changes nothing.
  const Setting setting;
  Map one = hand_built::empty_map(setting);
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 32; ++column) one.set_gap(column, row, 8.0);
  }
  Map two = one;
  for (int row = 0; row < 64; ++row) {
    for (int column = 20; column < 28; ++column) two.set_gap(column, row, 4.0);
  }
  const scene::Receivers receivers =
      hand_built::receivers(setting, {1, 1}, [](int, int) { return glm::dvec2(-0.1, 0.003); });
  const float with_one = same_map_estimate({one.atlas, one.cascades, receivers}).visibility[0];
  const float with_two = same_map_estimate({two.atlas, two.cascades, receivers}).visibility[0];
  const double tan_half = setting.tan_half();
  EXPECT_NEAR(with_one, hand_built::visible_past_edge(-0.1, 8.0, tan_half), resolution_bound);
  // Columns 20..27 at 4 m were at 8 m: their old places, -1.2 .. -0.4, are now open, and their new ones span
  // s.x from (-1.2 + 0.1) / (4 tan) = -6.3 to (-0.4 + 0.1) / (4 tan) = -1.72: off the disc. At 8 m they had
  // covered s.x < (-0.4 + 0.1) / (8 tan) = -0.86.
  const double opened = hand_built::visible_past_edge(-0.3, 8.0, tan_half);
  EXPECT_NEAR(with_two, with_one + opened, 2.0 * resolution_bound);
  // Nearer columns over the receiver cover what the rest of the layer leaves, not more.
  Map three = one;
  for (int row = 0; row < 64; ++row) {
    for (int column = 16; column < 32; ++column) three.set_gap(column, row, 16.0);
  }
  const double nearer = hand_built::visible_past_edge(-0.1, 16.0, tan_half);
  EXPECT_NEAR(same_map_estimate({three.atlas, three.cascades, receivers}).visibility[0], nearer,
              resolution_bound);
}

TEST(SameMap, TheReceiversOwnSurfaceDoesNotBlockIt) {
  // A slope of 60 degrees to the light, stored at texel centres and rounded to each format, is all lit.
  for (const bool reversed_z : {false, true}) {
    for (const scene::DepthFormat format :
         {scene::DepthFormat::d16, scene::DepthFormat::d24, scene::DepthFormat::d32}) {
      const Setting setting;
      const DiscLight disc = setting.disc();
      MapSettings settings;
      settings.reversed_z = reversed_z;
      settings.format = format;
      Map map = hand_built::empty_map(setting, settings);
      const double slope = std::tan(1.047);
      const double steps = format == scene::DepthFormat::d16 ? 65535.0 : 16777215.0;
      for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 64; ++column) {
          const double stored = map.stored_depth(slope * (0.1 * (column + 0.5) - 3.2));
          map.set_depth(column, row, static_cast<float>(std::round(stored * steps) / steps));
        }
      }
      scene::Receivers receivers = line(setting, 2.0);
      for (std::size_t x = 0; x < 64; ++x) {
        const double across = 2.0 * (2.0 * (static_cast<double>(x) + 0.5) / 64.0 - 1.0);
        receivers.position_relative[x] =
            glm::vec4(glm::vec3(setting.at(across, 0.003, slope * across)), 1.0F);
        receivers.normal_ws[x] =
            glm::vec4(glm::vec3(glm::normalize(disc.to_light - slope * disc.right)), 0.0F);
      }
      const VisibilityImage image = same_map_estimate({map.atlas, map.cascades, receivers});
      for (const float visibility : image.visibility) EXPECT_EQ(visibility, 1.0F);
    }
  }
}

TEST(SameMap, BlocksBeyondOneQuantumAndNotWithinIt) {
  Setting setting;
  setting.centre = glm::dvec3(0.0);
  MapSettings settings;
  settings.format = scene::DepthFormat::d16;
  Map map = hand_built::empty_map(setting, settings);
  const double quantum = 40.0 / 65535.0;
  const double lifted = surface_offset(glm::vec3(0.0F));
  const scene::Receivers receivers =
      hand_built::receivers(setting, {1, 1}, [](int, int) { return glm::dvec2(0.05, 0.05); });
  const auto visibility_under = [&](double height) {
    for (int row = 0; row < 64; ++row) {
      for (int column = 0; column < 64; ++column) map.set_gap(column, row, height);
    }
    return same_map_estimate({map.atlas, map.cascades, receivers}).visibility[0];
  };
  EXPECT_EQ(visibility_under(lifted + 0.98 * quantum), 1.0F);
  EXPECT_EQ(visibility_under(lifted + 1.02 * quantum), 0.0F);
}

TEST(SameMap, TexelsWithoutACasterDoNotBlock) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const bool reversed_z : {false, true}) {
    const Setting setting;
    MapSettings settings;
    settings.reversed_z = reversed_z;
    const scene::Receivers receivers = line(setting, 1.0);
    for (const float depth : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -1.0F, 2.0F,
                              reversed_z ? 0.0F : 1.0F}) {
      Map map = hand_built::empty_map(setting, settings);
      for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 64; ++column) map.set_depth(column, row, depth);
      }
      // This holds even for a receiver below everything that the map can store.
      scene::Receivers below = receivers;
      below.position_relative[0] = glm::vec4(glm::vec3(setting.at(0.0, 0.0, -12.0)), 1.0F);
      for (const float visibility : same_map_estimate({map.atlas, map.cascades, below}).visibility) {
        EXPECT_EQ(visibility, 1.0F) << "texels of " << depth;
      }
    }
  }
}

TEST(SameMap, OneNaNTexelAmongBlockersOpensOnlyItsSquare) {
  const Setting setting;
  Map map = hand_built::empty_map(setting);
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) map.set_gap(column, row, 10.0);
  }
  map.set_depth(32, 32, std::numeric_limits<float>::quiet_NaN());
  const scene::Receivers receivers =
      hand_built::receivers(setting, {1, 1}, [](int, int) { return glm::dvec2(0.05, 0.05); });
  const double radius = 10.0 * setting.tan_half();
  EXPECT_NEAR(same_map_estimate({map.atlas, map.cascades, receivers}).visibility[0],
              0.01 / (std::acos(-1.0) * radius * radius), resolution_bound);
}

TEST(SameMap, BeyondTheTileThereIsNoBlocker) {
  const Setting setting;
  Map map = hand_built::empty_map(setting);
  map.cascades.cascades[0].offset_scale = {0.5, 0.0, 0.5, 1.0};  // the right half of the atlas is the tile
  block_left_half(map, edge_gap);
  const scene::Receivers receivers = line(setting, 0.5);
  for (const float visibility : same_map_estimate({map.atlas, map.cascades, receivers}).visibility) {
    EXPECT_EQ(visibility, 1.0F);
  }
}

TEST(SameMap, PointLightReadsTheTexelOverTheReceiver) {
  Setting setting;
  setting.light.angular_diameter_degrees = 0.0;
  Map map = hand_built::empty_map(setting);
  block_left_half(map, edge_gap);
  const scene::Receivers receivers = line(setting, 6.0);  // the receivers lie beyond the map on both sides
  const VisibilityImage image = same_map_estimate({map.atlas, map.cascades, receivers});
  for (int x = 0; x < 64; ++x) {
    const double across = 6.0 * (2.0 * (x + 0.5) / 64.0 - 1.0);
    EXPECT_EQ(image.visibility[static_cast<std::size_t>(x)], across < 0.0 && across > -3.2 ? 0.0F : 1.0F)
        << x;
  }
}

// The texel's centre may lie above the receiver's plane and yet below the receiver, which it cannot shade.
TEST(SameMap, ATexelBelowTheReceiverDoesNotBlockAPointLight) {
  for (const double degrees : {0.0, 1.0}) {
    Setting setting;
    setting.light.angular_diameter_degrees = degrees;
    const DiscLight disc = setting.disc();
    Map map = hand_built::empty_map(setting);
    scene::Receivers receivers =
        hand_built::receivers(setting, {1, 1}, [](int, int) { return glm::dvec2(0.09, 0.05); });
    receivers.normal_ws[0] = glm::vec4(glm::vec3(glm::normalize(disc.to_light - 4.0 * disc.right)), 0.0F);
    map.set_gap(32, 32, -0.05);  // the plane is at -0.16 in the middle of the texel
    EXPECT_EQ(same_map_estimate({map.atlas, map.cascades, receivers}).visibility[0], 1.0F);
    map.set_gap(32, 32, 0.05);
    EXPECT_LT(same_map_estimate({map.atlas, map.cascades, receivers}).visibility[0], 0.05F);
  }
}

TEST(SameMap, CascadeIsTheFirstSphereThatHoldsThePosition) {
  parameters::CascadeSet set;
  set.cascades.resize(1);
  EXPECT_EQ(select_cascade(set, {1e6, 0.0, 0.0}), 0) << "one cascade needs no sphere";
  set.cascades.resize(3);
  set.cascades[0].split_sphere = {0.0, 0.0, 0.0, 2.0};
  set.cascades[1].split_sphere = {1.0, 0.0, 0.0, 4.0};
  set.cascades[2].split_sphere = {2.0, 0.0, 0.0, 8.0};
  EXPECT_EQ(select_cascade(set, {1.9, 0.0, 0.0}), 0);
  EXPECT_EQ(select_cascade(set, {2.1, 0.0, 0.0}), 1);
  EXPECT_EQ(select_cascade(set, {-3.1, 0.0, 0.0}), 2);
  EXPECT_EQ(select_cascade(set, {10.0, 0.0, 0.0}), -1) << "on the last sphere is outside";
}

TEST(SameMap, SameBytesFromEveryNumberOfThreads) {
  const Setting setting;
  Map map = hand_built::empty_map(setting);
  block_left_half(map, edge_gap);
  const scene::Receivers receivers = hand_built::receivers(
      setting, {48, 32}, [](int x, int y) { return glm::dvec2(0.01 * x - 0.2, 0.01 * y); });
  RunOptions one;
  one.jobs = 1;
  RunOptions many;
  many.jobs = 7;
  const MapView view{map.atlas, map.cascades, receivers};
  EXPECT_EQ(same_map_estimate(view, one), same_map_estimate(view, many));
}

TEST(SameMap, BadInputSaysWhatIsWrong) {
  const Setting setting;
  const scene::Receivers receivers = line(setting, 1.0);
  Map map = hand_built::empty_map(setting);
  Map none = map;
  none.cascades.cascades.clear();
  EXPECT_THROW(same_map_estimate({none.atlas, none.cascades, receivers}), InputError);
  Map short_atlas = map;
  short_atlas.atlas.depth.pop_back();
  EXPECT_THROW(same_map_estimate({short_atlas.atlas, short_atlas.cascades, receivers}), InputError);
  Map singular = map;
  singular.cascades.cascades[0].world_to_shadow = glm::dmat4(0.0);
  EXPECT_THROW(same_map_estimate({singular.atlas, singular.cascades, receivers}), InputError);
  Map off_atlas = map;
  off_atlas.cascades.cascades[0].offset_scale = {1.0, 0.0, 1.0, 1.0};
  EXPECT_THROW(same_map_estimate({off_atlas.atlas, off_atlas.cascades, receivers}), InputError);
}

}  // namespace
}  // namespace penumbra::reference
