// The passes of the variance maps and their filter, against the same sums in C++.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "resolve/graph_runner.h"
#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {
namespace {

constexpr int kColumns = 16;
constexpr double kReceiver = 0.7;  // of the map's range, from the light

// Steps and ramps; depth from the light.
double depth_at(double u, double v, int tile) {
  const double step = u + 0.3 * v > 0.6 ? 0.3 : 0.0;
  return 0.35 + step + 0.1 * v + 0.02 * tile;
}

struct VarianceMap {
  const scene::ShadowAtlas& atlas;
  int tile;  // side in texels
  double deviation;

  double centred(int x, int y) const {
    return 0.5 - static_cast<double>(atlas.depth[static_cast<std::size_t>(y * atlas.width + x)]);  // reversed
  }
  // Mean of a power of depth around a texel, by one sum over the square.
  double blurred(int x, int y, int power) const {
    const int reach = static_cast<int>(std::ceil(2.5 * deviation));
    const auto inside = [&](int i, int of) {
      return std::clamp(i, of / tile * tile, of / tile * tile + tile - 1);
    };
    double sum = 0.0, weights = 0.0;
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const double weight = std::exp(-0.5 * (dx * dx + dy * dy) / (deviation * deviation));
        sum += weight * std::pow(centred(inside(x + dx, x), inside(y + dy, y)), power);
        weights += weight;
      }
    return sum / weights;
  }
  double between(int x, int y, glm::ivec2 step, double fraction, int power) const {
    return (1.0 - fraction) * blurred(x, y, power) + fraction * blurred(x + step.x, y + step.y, power);
  }
  double bound(double mean, double square, double bleeding) const {
    const double variance = std::max(square - mean * mean, 1e-9);
    const double behind = kReceiver - 0.5 - mean;
    const double share = behind > 0.0 ? variance / (variance + behind * behind) : 1.0;
    return std::clamp((share - bleeding) / (1.0 - bleeding), 0.0, 1.0);
  }
  // At a texel's centre, which a device may take for a position 1/128 of a texel beside it: positions have 8
  // fractional bits, rounded either way.
  std::pair<double, double> visibility(int x, int y, double bleeding) const {
    double least = bound(blurred(x, y, 1), blurred(x, y, 2), bleeding), most = least;
    for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
      const auto inside = [&](int i, int by) { return (i + by) / tile == i / tile && i + by >= 0; };
      if (!inside(x, step.x) || !inside(y, step.y)) continue;
      const double beside =
          bound(between(x, y, step, 2.0 / 256.0, 1), between(x, y, step, 2.0 / 256.0, 2), bleeding);
      least = std::min(least, beside);
      most = std::max(most, beside);
    }
    return {least, most};
  }
};

TEST(VarianceMaps, GiveChebyshevsBoundOfTheBlurredDepths) {
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 64;
  setup.shadows.cascades = 4;
  setup.shadows.reversed_z = true;
  setup.cascade = 3;
  std::vector<testing_frames::TilePoint> receivers;
  for (int i = 0; i < kColumns * kColumns; ++i)  // centres of texels, the tile's first and last included
    receivers.emplace_back((i % kColumns * 2 + (i % kColumns < 8 ? 0.5 : 1.5)) / 32.0,
                           (i / kColumns * 2 + (i / kColumns < 8 ? 0.5 : 1.5)) / 32.0, 1.0 - kReceiver);
  const scene::Frame frame = testing_frames::make_frame(
      setup, [](double u, double v, int tile) { return static_cast<float>(1.0 - depth_at(u, v, tile)); },
      receivers, kColumns);
  const techniques::TechniqueList& list = library_techniques();
  const techniques::Technique& technique = list.find("variance-32");
  GraphRunner runner(test_device(), compile(technique_graph(list, technique)));
  const GraphResult result =
      runner.run(FrameOnDevice(test_device(), frame), {.noise_seeds = 1, .timing_repeats = 0});

  const VarianceMap map{frame.atlas, frame.cascades.tile_resolution, technique.values.at("deviation")[0]};
  const glm::dvec4 tile = frame.cascades.cascades[3].offset_scale;
  int between = 0;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const int x = static_cast<int>((tile.x + receivers[i].x * tile.z) * frame.atlas.width);
    const int y = static_cast<int>((tile.y + receivers[i].y * tile.w) * frame.atlas.height);
    const auto [least, most] = map.visibility(x, y, technique.values.at("bleeding")[0]);
    EXPECT_GE(result.visibility[0][i], least - 1e-4) << x << ", " << y;
    EXPECT_LE(result.visibility[0][i], most + 1e-4) << x << ", " << y;
    between += least > 0.05 && most < 0.95 ? 1 : 0;
  }
  EXPECT_GT(between, 15) << "penumbra receivers";
  EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());

  // Nine taps for each texel in rows and columns.
  const double texels = static_cast<double>(frame.atlas.width) * frame.atlas.height / (kColumns * kColumns);
  ASSERT_EQ(result.passes.size(), 3U);
  EXPECT_DOUBLE_EQ(result.passes[0].fetches, 9.0 * texels);
  EXPECT_DOUBLE_EQ(result.passes[1].fetches, 9.0 * texels);
  EXPECT_DOUBLE_EQ(result.passes[1].texels_written, texels);
  EXPECT_DOUBLE_EQ(result.passes[2].fetches, 1.0);
}

}  // namespace
}  // namespace penumbra::resolve
