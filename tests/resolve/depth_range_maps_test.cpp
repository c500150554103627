// Compares the maps of nearest and farthest depths and the quarter-resolution variance map, texel by texel,
// with the same in C++: integers and floats are the same bit for bit, with texels of NaN, both directions of
// depth, and tiles that must not mix.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <random>

#include "resolve/kept_runners.h"
#include "resolve/run_once.h"
#include "resolve/shadow_shader.h"
#include "resolve/synthetic_frame.h"

namespace penumbra::resolve {
namespace {

techniques::TechniqueList test_graphs() {
  return techniques::read_technique_list(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests" / "resolve" /
                                         "ranges" / "ReadRange.technique.json");
}

std::minstd_rand engine_of(double u, double v, int tile) {
  std::minstd_rand engine(static_cast<unsigned>(u * 7919.0 * 8.0) * 31u +
                          static_cast<unsigned>(v * 7919.0) * 17u + static_cast<unsigned>(tile) * 7u + 1u);
  engine.discard(3);
  return engine;
}

// The depths are multiples of 1/256, whose products with 65535, differences and squares are floats without
// rounding; each cascade has others. Of every 32 texels one is NaN, one lies beyond the range.
float coarse_depth(double u, double v, int tile) {
  std::minstd_rand engine = engine_of(u, v, tile);
  const unsigned kind = engine() % 32u;
  if (kind == 0) return std::numeric_limits<float>::quiet_NaN();
  if (kind == 1) return engine() % 2u == 0 ? std::numeric_limits<float>::infinity() : -2.0f;
  const unsigned span = engine() % 3u == 0 ? 257u : 16u;
  return static_cast<float>(64u * (static_cast<unsigned>(tile) % 3u) * (span == 16u ? 1u : 0u) +
                            engine() % span) /
         256.0f;
}

// Depths that no step of the format meets.
float fine_depth(double u, double v, int tile) {
  std::minstd_rand engine = engine_of(u, v, tile);
  return 0.4f + 0.2f * std::generate_canonical<float, 24>(engine);
}

struct Range {
  double nearest, farthest;
};

// The maps' values are computed from the shadow map itself.
struct Expected {
  const scene::Frame& frame;
  bool reversed;

  int tile() const { return frame.cascades.tile_resolution; }
  float depth(int x, int y) const {
    const float stored = frame.atlas.depth[static_cast<std::size_t>(y * frame.atlas.width + x)];
    if (std::isnan(stored)) return reversed ? 0.0f : 1.0f;
    return std::min(std::max(stored, 0.0f), 1.0f);
  }
  Range joined(const Range& a, const Range& b) const {
    return reversed ? Range{std::max(a.nearest, b.nearest), std::min(a.farthest, b.farthest)}
                    : Range{std::min(a.nearest, b.nearest), std::max(a.farthest, b.farthest)};
  }
  // The range of a square of `side` texels of the shadow map at a multiple of its side; not rounded.
  Range of_square(int x, int y, int side) const {
    Range range = {depth(x * side, y * side), depth(x * side, y * side)};
    for (int i = 0; i < side * side; ++i) {
      const double d = depth(x * side + i % side, y * side + i / side);
      range = joined(range, {d, d});
    }
    return range;
  }
  // A depth in steps of the format, outward, by 1/64 of a step at least.
  static double up(double depth) { return std::min(std::ceil(65535.0 * depth + 1.0 / 64.0), 65535.0); }
  static double down(double depth) { return std::max(std::floor(65535.0 * depth - 1.0 / 64.0), 0.0); }
  Range rounded(const Range& range) const {
    return reversed ? Range{up(range.nearest), down(range.farthest)}
                    : Range{down(range.nearest), up(range.farthest)};
  }
  // The range, in steps, of a disc of quarter-resolution texels inside of the tile.
  Range dilated(int x, int y, int radius, double& cells) const {
    const int quarter = tile() / 4;
    Range range = of_square(x, y, 4);
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) {
        const auto inside = [&](int at, int by) {
          return at + by >= 0 && (at + by) / quarter == at / quarter;
        };
        if (dx * dx + dy * dy > radius * radius || !inside(x, dx) || !inside(y, dy)) continue;
        range = joined(range, of_square(x + dx, y + dy, 4));
        cells += 1.0;
      }
    return rounded(range);
  }
  std::array<double, 2> moments(int x, int y) const {
    std::array<double, 2> sums{};
    for (int i = 0; i < 16; ++i) {
      const double stored = depth(4 * x + i % 4, 4 * y + i / 4);
      const double centred = reversed ? 0.5 - stored : stored - 0.5;
      sums[0] += centred / 16.0;
      sums[1] += centred * centred / 16.0;
    }
    return sums;
  }
};

class DepthRangeMaps : public testing::TestWithParam<bool> {
 protected:
  // The receivers are at the centres of a tile's texels, `side` to a row.
  scene::Frame frame(const testing_frames::TexelDepth& map, int cascade, int side) const {
    testing_frames::FrameSetup setup;
    setup.shadows.resolution = 128;
    setup.shadows.cascades = 4;
    setup.shadows.reversed_z = GetParam();
    setup.cascade = cascade;
    std::vector<testing_frames::TilePoint> receivers;
    for (int i = 0; i < side * side; ++i)
      receivers.emplace_back((i % side + 0.5) / side, (i / side + 0.5) / side, 0.5);
    return testing_frames::make_frame(setup, map, receivers, side);
  }

  struct Read {
    std::vector<float> texels;  // texels of the cascade's tile
    std::vector<PassCounts> passes;
  };
  Read read(const std::string& graph, const scene::Frame& frame, int channel, int level = 0) const {
    const techniques::TechniqueList list = test_graphs();
    techniques::Technique technique = list.find(graph);
    technique.values["channel"] = {static_cast<double>(channel)};
    technique.values["level"] = {static_cast<double>(level)};
    static KeptRunners runners;
    GraphRunner& runner = runners.of(
        graph, GetParam(), [&] { return technique_graph(list, technique, Taps::as_listed, GetParam()); });
    runner.set_parameters(parameter_uniforms(list, technique));
    GraphResult result = runner.run(FrameOnDevice(test_device(), frame), kCountedOnce);
    EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
    return {std::move(result.visibility.front()), std::move(result.passes)};
  }

  static glm::ivec2 origin(const scene::Frame& frame, int cascade, int texels_per_texel) {
    const glm::dvec4 tile = frame.cascades.cascades[static_cast<std::size_t>(cascade)].offset_scale;
    return {static_cast<int>(std::lround(tile.x * frame.atlas.width)) / texels_per_texel,
            static_cast<int>(std::lround(tile.y * frame.atlas.height)) / texels_per_texel};
  }

  // Expects the graph's two channels over a tile to be the ranges in steps; returns the passes that made
  // them. A device makes of an integer its quotient, within a rounding.
  std::vector<PassCounts> expect_ranges(const std::string& graph, const scene::Frame& made, int side,
                                        int level, const std::function<Range(int x, int y)>& expected) const {
    const Read nearest = read(graph, made, 0, level), farthest = read(graph, made, 1, level);
    for (int i = 0; i < side * side; ++i) {
      const Range range = expected(i % side, i / side);
      for (const auto& [got, steps] :
           {std::pair(&nearest, range.nearest), std::pair(&farthest, range.farthest)}) {
        const float texel = got->texels[static_cast<std::size_t>(i)];
        const char* end = got == &nearest ? "nearest" : "farthest";
        EXPECT_EQ(std::lround(65535.0 * static_cast<double>(texel)), std::lround(steps))
            << end << " of level " << level << ", " << i;
        EXPECT_NEAR(texel, steps / 65535.0, 1.2e-7) << end << " of level " << level << ", " << i;
      }
    }
    return farthest.passes;
  }
};

TEST_P(DepthRangeMaps, AQuarterTexelHasTheRangeOfItsSixteen) {
  for (int cascade = 0; cascade < 4; ++cascade) {
    const scene::Frame made = frame(coarse_depth, cascade, 16);
    const Expected expected{made, GetParam()};
    const glm::ivec2 first = origin(made, cascade, 4);
    const std::vector<PassCounts> passes = expect_ranges("quarter", made, 16, 0, [&](int x, int y) {
      return expected.rounded(expected.of_square(first.x + x, first.y + y, 4));
    });
    // There are four gathers for each of the map's quarter texels, in all cascades.
    EXPECT_DOUBLE_EQ(passes[0].fetches, 4.0 * (made.atlas.width / 4.0) * (made.atlas.height / 4.0) / 256.0);
  }
}

TEST_P(DepthRangeMaps, ADilationHasTheRangeOfItsDiscInsideOfTheTile) {
  constexpr std::array<int, 4> kRadii{8, 4, 3, 0};
  double cells_of_all = 0.0;
  std::vector<PassCounts> last;
  for (int cascade = 0; cascade < 4; ++cascade) {
    const scene::Frame made = frame(coarse_depth, cascade, 16);
    const Expected expected{made, GetParam()};
    const glm::ivec2 first = origin(made, cascade, 4);
    last = expect_ranges("dilated", made, 16, 0, [&](int x, int y) {
      return expected.dilated(first.x + x, first.y + y, kRadii[static_cast<std::size_t>(cascade)],
                              cells_of_all);
    });
  }
  EXPECT_DOUBLE_EQ(last[1].fetches, cells_of_all / 256.0) << "one load for each cell inside of the tile";
}

TEST_P(DepthRangeMaps, EachLevelHasTheRangeOfItsTexels) {
  for (int cascade = 0; cascade < 4; ++cascade) {
    for (int level = 0; level <= 4; ++level) {  // levels of 16, 8, 4, 2 and 1 texels of the tile
      const int side = 16 >> level;
      const scene::Frame made = frame(coarse_depth, cascade, side);
      const Expected expected{made, GetParam()};
      const glm::ivec2 first = origin(made, cascade, 4 << level);
      expect_ranges("levels", made, side, level, [&](int x, int y) {
        return expected.rounded(expected.of_square(first.x + x, first.y + y, 4 << level));
      });
    }
  }
}

TEST_P(DepthRangeMaps, AreNeverInsideOfTheTrueRange) {
  const double toward_light = GetParam() ? 1.0 : -1.0;
  for (int level = 0; level <= 4; ++level) {
    const int side = 16 >> level;
    const scene::Frame made = frame(fine_depth, 1, side);
    const Expected expected{made, GetParam()};
    const Read nearest = read("levels", made, 0, level), farthest = read("levels", made, 1, level);
    const glm::ivec2 first = origin(made, 1, 4 << level);
    for (int i = 0; i < side * side; ++i) {
      const Range range = expected.of_square(first.x + i % side, first.y + i / side, 4 << level);
      const double before = toward_light * (nearest.texels[static_cast<std::size_t>(i)] - range.nearest);
      const double behind = toward_light * (range.farthest - farthest.texels[static_cast<std::size_t>(i)]);
      ASSERT_GE(before, 0.0) << level << ", " << i;
      ASSERT_GE(behind, 0.0) << level << ", " << i;
      ASSERT_LE(before, 1.1 / 65535.0) << "rounded once, not at each level: " << level << ", " << i;
      ASSERT_LE(behind, 1.1 / 65535.0) << level << ", " << i;
    }
  }
}

// Every texel lies between its block's planes; on a plane surface, they are the surface at every level.
TEST_P(DepthRangeMaps, PlanesHoldTheTexelsOfTheirBlock) {
  const double toward_light = GetParam() ? 1.0 : -1.0;
  const auto slope = [](double u, double v, int tile) {
    return static_cast<float>(0.3 + 0.2 * u - 0.1 * v + 0.1 * tile);
  };
  const std::vector<std::pair<testing_frames::TexelDepth, bool>> maps{
      {coarse_depth, false}, {fine_depth, false}, {slope, true}};
  for (const auto& [map, is_plane] : maps) {
    for (int level = 0; level <= 4; ++level) {
      const int side = 16 >> level, texels = 4 << level;
      const scene::Frame made = frame(map, 2, side);
      const Expected expected{made, GetParam()};
      std::array<std::vector<float>, 4> planes;
      for (std::size_t k = 0; k < 4; ++k) planes[k] = read("planes", made, static_cast<int>(k), level).texels;
      const glm::ivec2 first = origin(made, 2, texels);
      double thickest = 0.0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(side * side); ++i) {
        const int x = (first.x + static_cast<int>(i) % side) * texels,
                  y = (first.y + static_cast<int>(i) / side) * texels;
        thickest = std::max(thickest, toward_light * (planes[2][i] - planes[3][i]));
        for (int texel = 0; texel < texels * texels; ++texel) {
          const double dx = texel % texels + 0.5 - texels / 2.0, dy = texel / texels + 0.5 - texels / 2.0;
          const double rest =
              expected.depth(x + texel % texels, y + texel / texels) - planes[0][i] * dx - planes[1][i] * dy;
          ASSERT_GE(toward_light * (planes[2][i] - rest), -2e-6)
              << "level " << level << ", " << i << ", " << texel;
          ASSERT_GE(toward_light * (rest - planes[3][i]), -2e-6)
              << "level " << level << ", " << i << ", " << texel;
        }
      }
      EXPECT_EQ(thickest < 1e-5, is_plane) << "level " << level << ": " << thickest;
    }
  }
}

TEST_P(DepthRangeMaps, TheVarianceMapHasMeanAndMeanSquare) {
  for (int cascade = 0; cascade < 4; ++cascade) {
    const scene::Frame made = frame(coarse_depth, cascade, 16);
    const Expected expected{made, GetParam()};
    const Read mean = read("moments", made, 0), square = read("moments", made, 1);
    const glm::ivec2 first = origin(made, cascade, 4);
    for (int i = 0; i < 256; ++i) {
      const std::array<double, 2> moments = expected.moments(first.x + i % 16, first.y + i / 16);
      ASSERT_EQ(mean.texels[static_cast<std::size_t>(i)], moments[0]) << i;
      ASSERT_EQ(square.texels[static_cast<std::size_t>(i)], moments[1]) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BothDirections, DepthRangeMaps, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
