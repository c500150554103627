// Tests FilterPcssAngular and FilterPcssBounded on maps whose answer is known: two layers that hide the light
// together, the rim of a penumbra, and an edge a texel wide.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>

#include "resolve/kept_runners.h"
#include "resolve/synthetic_frame.h"

namespace penumbra::resolve {
namespace {

using testing::Each;
using testing::Ge;
using testing::Le;
using testing_frames::FrameSetup;
using testing_frames::TexelDepth;
using testing_frames::TilePoint;

constexpr int kTileTexels = 512;
constexpr double kReceiverDistance = 0.6;  // distance from the light's end of the depth range, 0 to 1

struct AngularTechnique {
  const char* test_name;
  const char* name;
  const char* search;  // its number of samples of the search
};

constexpr AngularTechnique kAngularTechniques[] = {{"Angular", "pcss-angular-24-16", "blockerSamples"},
                                                   {"Bounded", "pcss-bounded-16-16", "searchSamples"}};

class AngularFilter : public testing::TestWithParam<std::tuple<bool, AngularTechnique>> {
 protected:
  static bool is_reversed() { return std::get<0>(GetParam()); }
  static const AngularTechnique& tested() { return std::get<1>(GetParam()); }

  void SetUp() override {
    setup_.shadows.cascades = 1;
    setup_.shadows.resolution = kTileTexels;
    setup_.shadows.reversed_z = is_reversed();
    setup_.light.direction = {0.0, -1.0, 0.0};
  }

  float nothing() const { return testing_frames::farthest_depth(is_reversed()); }
  double depth(double distance) const { return is_reversed() ? 1.0 - distance : distance; }
  // The depth of a blocker that stands `gap` nearer to the light than the receivers, in shares of the depth
  // range.
  float blocker(double gap) const { return static_cast<float>(depth(kReceiverDistance - gap)); }

  // Sets the angular diameter at which a gap makes a penumbra of that radius.
  void set_light(double gap, double radius_texels) {
    const parameters::CascadeSet set = parameters::fit_cascades(setup_.camera, setup_.light, setup_.shadows);
    const parameters::Cascade& cascade = set.cascades.front();
    const double radius_metres = radius_texels * cascade.texel_size_metres;
    setup_.light.angular_diameter_degrees =
        2.0 * std::atan(radius_metres * cascade.depth_per_metre / gap) * 180.0 / M_PI;
  }

  // Resolves receivers along the tile's middle, at these texels from its centre line.
  GraphResult resolve(const TexelDepth& map, const std::vector<double>& texels,
                      const std::vector<std::pair<std::string, int>>& counts, int seeds) const {
    std::vector<TilePoint> receivers;
    for (const double x : texels) {
      receivers.emplace_back(0.5 + x / kTileTexels, 0.5 + 0.3 / kTileTexels, depth(kReceiverDistance));
    }
    const scene::Frame frame =
        testing_frames::make_frame(setup_, map, receivers, static_cast<int>(receivers.size()));
    techniques::Technique technique = library_techniques().find(tested().name);
    for (const auto& [name, count] : counts) technique.values.at(name) = {static_cast<double>(count)};
    const ShadowShader shader =
        technique_shader(library_techniques(), technique, Taps::as_listed, is_reversed());
    GraphRunner runner(test_device(), compile(shader));
    return runner.run(FrameOnDevice(test_device(), frame),
                      {.noise_seeds = seeds, .first_seed = 0, .timing_repeats = 0, .count_fetches = true});
  }

  static std::vector<double> steps(double first, double last, int count) {
    std::vector<double> all;
    for (int i = 0; i < count; ++i) all.push_back(first + (last - first) * i / (count - 1));
    return all;
  }

  static std::vector<double> means(const GraphResult& result) {
    std::vector<double> sums(result.visibility.front().size(), 0.0);
    for (const std::vector<float>& seen : result.visibility) {
      for (std::size_t i = 0; i < seen.size(); ++i)
        sums[i] += seen[i] / static_cast<double>(result.visibility.size());
    }
    return sums;
  }

  FrameSetup setup_;
};

// A roof is over everything left of the middle, a wall a tenth as high over everything right of it. To the
// right of the middle every ray ends: those to the right, and the steepest to the left, in the wall, all
// others at the roof.
TEST_P(AngularFilter, LetsNoLightThroughBetweenAHighRoofAndALowWall) {
  constexpr double kRoof = 0.5;
  constexpr double kWall = 0.05;
  set_light(kRoof, 24.0);
  const auto map = [this](double u, double, int) { return u < 0.5 ? blocker(kRoof) : blocker(kWall); };
  const GraphResult result = resolve(map, steps(0.5, 12.0, 24), {}, 4);
  for (const std::vector<float>& seen : result.visibility) EXPECT_THAT(seen, Each(Le(0.01f)));
}

// Leaves are high above everything, and below them a board is over everything left of the middle: the light
// that passes the leaves ends at the board, and what lies beside the board stays as it is without one.
TEST_P(AngularFilter, ALowBlockerKeepsItsShadowBelowHighLeaves) {
  constexpr double kLeaves = 0.5;
  constexpr double kBoard = 0.02;
  set_light(kLeaves, 24.0);
  const auto is_leaf = [](double u, double v) {
    const auto square = [](double at) { return static_cast<int>(std::floor(at * kTileTexels / 2.0)); };
    return (square(u) + square(v)) % 2 == 0;
  };
  const auto leaves = [&](double u, double v, int) { return is_leaf(u, v) ? blocker(kLeaves) : nothing(); };
  const auto both = [&](double u, double v, int) {
    return is_leaf(u, v) ? blocker(kLeaves) : (u < 0.5 ? blocker(kBoard) : nothing());
  };
  const GraphResult below = resolve(both, steps(-40.0, -1.5, 78), {}, 4);
  for (const std::vector<float>& seen : below.visibility) EXPECT_THAT(seen, Each(Le(0.02f)));
  const std::vector<double> beside = steps(2.0, 40.0, 77);
  const std::vector<double> with_board = means(resolve(both, beside, {}, 4));
  const std::vector<double> without = means(resolve(leaves, beside, {}, 4));
  for (std::size_t i = 0; i < beside.size(); ++i) {
    EXPECT_NEAR(without[i], 0.5, 0.2) << beside[i];
    EXPECT_NEAR(with_board[i], without[i], 0.1) << beside[i] << " texels from the board";
  }
}

// One caster has a straight edge: visibility is the share of the light's disc beyond the edge.
double half_plane(double distance_in_radii) {
  const double d = std::clamp(distance_in_radii, -1.0, 1.0);
  return 0.5 + (std::asin(d) + d * std::sqrt(1.0 - d * d)) / M_PI;
}

// Six samples hit a sliver of the light's cone only now and then; the light must not depend on it.
TEST_P(AngularFilter, FewSearchSamplesKeepTheRimOfAPenumbra) {
  constexpr double kGap = 0.1;
  constexpr double kRadius = 8.0;
  set_light(kGap, kRadius);
  const auto map = [this](double u, double, int) { return u < 0.5 ? blocker(kGap) : nothing(); };
  const std::vector<double> places = steps(-7.5, 7.5, 31);
  const std::vector<double> seen =
      means(resolve(map, places, {{tested().search, 6}, {"filterSamples", 32}}, 32));
  double squared = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double error = seen[i] - half_plane(places[i] / kRadius);
    EXPECT_NEAR(error, 0.0, 0.09) << places[i] << " texels from the edge";
    squared += error * error;
  }
  EXPECT_LE(std::sqrt(squared / static_cast<double>(seen.size())), 0.035);
}

// Every texel near the receiver is read once, whatever the noise.
TEST_P(AngularFilter, ANarrowPenumbraCostsFourFetchesHasNoNoiseAndNoSteps) {
  constexpr double kGap = 0.1;
  set_light(kGap, 0.5);
  const auto map = [this](double u, double, int) { return u < 0.5 ? blocker(kGap) : nothing(); };
  const GraphResult result = resolve(map, steps(-2.5, 2.5, 161), {}, 4);
  const auto searched =
      static_cast<unsigned>(library_techniques().find(tested().name).values.at(tested().search).front());
  EXPECT_THAT(result.fetches, Each(testing::AnyOf(searched, searched + 4)));
  EXPECT_THAT(result.fetches, testing::Contains(searched + 4));
  const std::vector<float>& first = result.visibility.front();
  for (const std::vector<float>& seen : result.visibility) {
    for (std::size_t i = 0; i < seen.size(); ++i) ASSERT_NEAR(seen[i], first[i], 1e-6) << i;
  }
  EXPECT_EQ(first.front(), 0.0f);
  EXPECT_EQ(first.back(), 1.0f);
  for (std::size_t i = 1; i < first.size(); ++i) {
    ASSERT_THAT(first[i] - first[i - 1], testing::AllOf(Ge(-1e-5f), Le(0.06f)))
        << "step " << i << " of 1/32 texel";
  }
}

INSTANTIATE_TEST_SUITE_P(Depth, AngularFilter,
                         testing::Combine(testing::Bool(), testing::ValuesIn(kAngularTechniques)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param) ? "Reversed" : "Conventional") +
                                  std::get<1>(tested.param).test_name;
                         });

}  // namespace
}  // namespace penumbra::resolve
