// Compares the maps of depth planes and of depth spreads as draws and kernels make them: they have the same
// bits at every level of every tile, over maps of formulas and over adversarial ones, and the spreads are
// those of the map's texels.
#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "resolve/adversarial_maps.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"
#include "resolve/shadow_shader.h"
#include "resolve/synthetic_frame.h"

namespace penumbra::resolve {
namespace {

constexpr int kBlockTile = 64;  // texels
constexpr int kBlockLevels = 5;
constexpr int kBlockChannels = 12;  // channels, 4 of the planes and 2 of each cell

class DepthBlockMaps : public testing::TestWithParam<bool> {
 protected:
  // The receivers are at the centres of a tile's blocks of a level.
  scene::Frame frame(const testing_frames::TexelDepth& map, int cascade, int cascades, int level) const {
    testing_frames::FrameSetup setup;
    setup.shadows.cascades = cascades;
    setup.shadows.resolution = cascades == 1 ? kBlockTile : 2 * kBlockTile;
    setup.shadows.reversed_z = GetParam();
    setup.cascade = cascade;
    const int side = kBlockTile / 4 >> level;
    std::vector<testing_frames::TilePoint> receivers;
    for (int i = 0; i < side * side; ++i)
      receivers.emplace_back((i % side + 0.5) / side, (i / side + 0.5) / side, 0.5);
    return testing_frames::make_frame(setup, map, receivers, side);
  }

  std::vector<float> read(const std::string& graph, const FrameOnDevice& frame, int level,
                          int channel) const {
    static const techniques::TechniqueList list =
        techniques::read_technique_list(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests" / "resolve" /
                                        "ranges" / "ReadBlock.technique.json");
    techniques::Technique technique = list.find(graph);
    technique.values["level"] = {static_cast<double>(level)};
    technique.values["channel"] = {static_cast<double>(channel)};
    static KeptRunners runners;
    GraphRunner& runner = runners.of(
        graph, GetParam(), [&] { return technique_graph(list, technique, Taps::as_listed, GetParam()); });
    runner.set_parameters(parameter_uniforms(list, technique));
    GraphResult result = runner.run(frame, nullptr, kOnce);
    EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
    return std::move(result.visibility.front());
  }

  // Kernels and draws may or may not flush denormals, so what sums of them make, up to 2^-100, counts as 0.
  static std::vector<std::uint32_t> bits(const std::vector<float>& values) {
    std::vector<std::uint32_t> all;
    for (const float value : values)
      all.push_back(std::fabs(value) < 0x1p-100F ? 0U : std::bit_cast<std::uint32_t>(value));
    return all;
  }
};

TEST_P(DepthBlockMaps, OfDrawsAndOfKernelsAreTheSameBits) {
  std::size_t differing = 0, compared = 0;
  std::vector<NamedHeights> maps = adversarial_maps();
  maps.push_back({"denormals", [](int x, int y) { return std::ldexp(share_of(x, y, 31), -130); }});
  int drawing = 0;
  for (const NamedHeights& map : maps) {
    const int cascades = drawing % 2 == 0 ? 4 : 1;
    const int cascade = cascades == 1 ? 0 : drawing / 2 % 4;
    const int salt = drawing++;
    const auto depth = [&](double u, double v, int tile) {
      const int shift = 61 * (tile + salt);  // each tile has another piece of the map
      return stored_height(
          map.height(static_cast<int>(u * kBlockTile) + shift, static_cast<int>(v * kBlockTile) + shift / 2),
          GetParam());
    };
    for (int level = 0; level < kBlockLevels; ++level) {
      const scene::Frame made = frame(depth, cascade, cascades, level);
      const FrameOnDevice on_device(test_device(), made);
      for (int channel = 0; channel < kBlockChannels; ++channel) {
        const std::vector<float> drawn = read("raster-blocks", on_device, level, channel);
        ASSERT_EQ(bits(drawn), bits(read("kernel-blocks", on_device, level, channel)))
            << map.name << ", level " << level << ", channel " << channel;
        for (const float value : drawn) {
          ASSERT_TRUE(std::isfinite(value)) << map.name;
          differing += value != drawn.front() ? 1 : 0;
        }
        compared += drawn.size();
      }
    }
  }
  EXPECT_GT(5 * differing, compared) << "the maps must not be the same everywhere";
}

// The mean and the deviation are those of all of a cell's texels, whatever the number of levels between.
TEST_P(DepthBlockMaps, CellsHaveTheMeanAndTheDeviationOfTheirTexels) {
  for (const NamedHeights& map : adversarial_maps()) {
    const auto depth = [&](double u, double v, int tile) {
      return stored_height(
          map.height(static_cast<int>(u * kBlockTile) + 64 * tile, static_cast<int>(v * kBlockTile)),
          GetParam());
    };
    for (int level = 0; level < kBlockLevels; ++level) {
      constexpr int kCascade = 2;
      const scene::Frame made = frame(depth, kCascade, 4, level);
      const FrameOnDevice on_device(test_device(), made);
      const int side = kBlockTile / 4 >> level, cell = 2 << level;
      for (int k = 0; k < 4; ++k) {
        const std::vector<float> deviations = read("raster-blocks", on_device, level, 4 + 2 * k);
        const std::vector<float> means = read("raster-blocks", on_device, level, 5 + 2 * k);
        for (int i = 0; i < side * side; ++i) {
          const int x = 2 * cell * (i % side) + cell * (k % 2), y = 2 * cell * (i / side) + cell * (k / 2);
          long double mean = 0.0L, square = 0.0L;
          for (int texel = 0; texel < cell * cell; ++texel) {
            const double stored = static_cast<double>(made.atlas.depth[static_cast<std::size_t>(
                (kBlockTile + y + texel / cell) * 2 * kBlockTile + x + texel % cell)]);
            const double far = GetParam() ? 0.0 : 1.0;
            const double known = std::isnan(stored) ? far : std::min(std::max(stored, 0.0), 1.0);
            mean += static_cast<long double>(known);
            square += static_cast<long double>(known) * static_cast<long double>(known);
          }
          mean /= cell * cell;
          const long double variance = std::max(square / (cell * cell) - mean * mean, 0.0L);
          const auto at = static_cast<std::size_t>(i);
          const std::string where = map.name + ", level " + std::to_string(level) + ", cell " +
                                    std::to_string(k) + " of block " + std::to_string(i);
          // Each level rounds a mean by half a step; the mean of four rounded means moves by no more.
          const double mean_error = (level + 1) * 0.51 / 65535.0;
          ASSERT_NEAR(means[at] / 65535.0, static_cast<double>(mean), mean_error) << where;
          // A deviation is a length in the space of its parts' means and deviations: it moves by no more than
          // those errors of the level before, and rounds by a quarter of a step.
          const double deviation_error = (level + 1) * 0.26 * (1 + level) / 65535.0;
          ASSERT_NEAR(deviations[at] / 131070.0, static_cast<double>(std::sqrt(variance)),
                      deviation_error + 1e-6)
              << where;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BothDirections, DepthBlockMaps, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
