// Compares summed-area tables and mip levels of the map with sums in C++: bit by bit where they are integers,
// and within the rounding of their format elsewhere.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "resolve/probe_graph.h"
#include "resolve/run_once.h"
#include "resolve/synthetic_frame.h"

namespace penumbra::resolve {
namespace {

using Digits = std::array<std::uint32_t, 4>;
using Sums = std::vector<Digits>;

// The depths are multiples of 2^-12, whose digits and squares no rounding touches.
double exact_depth(double u, double v, int tile) {
  const auto hash = static_cast<std::uint32_t>(u * 4099.0) * 2654435761u +
                    static_cast<std::uint32_t>(v * 4093.0) * 2246822519u +
                    static_cast<std::uint32_t>(tile) * 77u;
  return std::ldexp(double((hash ^ hash >> 13) % 4097u), -12);
}

Digits depth_digits(double centred) {
  const auto steps = std::min<std::uint32_t>(std::uint32_t(std::ldexp(centred + 0.5, 24)), 16777215u);
  const auto square = std::min<std::uint32_t>(std::uint32_t(std::ldexp(centred * centred, 26)), 16777215u);
  return {steps >> 12, steps & 4095u, square >> 12, square & 4095u};
}

Digits moment_digits(double centred) {
  const double z = 2.0 * centred, third = z * z * z;
  const auto digit = [](double stored) { return std::uint32_t(stored * 65535.0 + 0.5); };
  return {digit(0.5 + 1.5 * z - 2.0 * third), digit(4.0 * z * z - 4.0 * z * z * z * z),
          digit(0.5 + std::sqrt(3.0) / 2.0 * z - 2.0 * std::sqrt(3.0) / 9.0 * third), digit(z * z * z * z)};
}

struct Tile {
  const scene::Frame& frame;
  int side;
  glm::ivec2 origin;

  explicit Tile(const scene::Frame& of, int cascade) : frame(of), side(of.cascades.tile_resolution) {
    const glm::dvec4 tile = of.cascades.cascades.at(static_cast<std::size_t>(cascade)).offset_scale;
    origin = {std::lround(tile.x * of.atlas.width), std::lround(tile.y * of.atlas.height)};
  }
  double centred(int x, int y) const {
    return 0.5 - static_cast<double>(
                     frame.atlas
                         .depth[static_cast<std::size_t>((y + origin.y) * frame.atlas.width + x + origin.x)]);
  }
  template <typename Function>
  Sums sums(const Function& digits) const {
    Sums sums(static_cast<std::size_t>(side * side));
    for (int y = 0; y < side; ++y) {
      Digits row{};
      for (int x = 0; x < side; ++x) {
        const Digits own = digits(centred(x, y));
        const auto at = static_cast<std::size_t>(y * side + x);
        for (std::size_t k = 0; k < 4; ++k) {
          row[k] += own[k];
          sums[at][k] = row[k] + (y > 0 ? sums[at - static_cast<std::size_t>(side)][k] : 0u);
        }
      }
    }
    return sums;
  }
};

// `places` is the number of binary places of the depths.
scene::Frame frame_of(int resolution, int cascades, int cascade, int step, int places = 12) {
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = resolution;
  setup.shadows.cascades = cascades;
  setup.shadows.reversed_z = true;
  setup.cascade = cascade;
  const int tile = resolution / (cascades > 1 ? 2 : 1), columns = tile / step;
  std::vector<testing_frames::TilePoint> receivers;
  for (int y = step - 1; y < tile; y += step)
    for (int x = step - 1; x < tile; x += step)
      receivers.emplace_back((x + 0.5) / tile, (y + 0.5) / tile, 0.5);
  const auto depth = [places](double u, double v, int t) {
    return static_cast<float>(1.0 -
                              std::ldexp(std::round(std::ldexp(exact_depth(u, v, t), places)), -places));
  };
  return testing_frames::make_frame(setup, depth, receivers, columns);
}

// Half of the bits of one channel, 16 of them, which a float holds exactly.
std::string half_of_channel(int channel, int half) {
  return "    const uint4 sum = LOAD_TEXTURE2D(_PenumbraSumsTexture, "
         "int2(TexelCoordinates(receiver.shadowCoord.xy, "
         "tile)));\n    return float((sum[" +
         std::to_string(channel) + "] >> " + std::to_string(16 * half) + ") & 0xFFFFu);\n";
}

template <typename Function>
void expect_sums(const std::string& technique, const scene::Frame& frame, int cascade, int step,
                 const Function& digits) {
  const Tile tile(frame, cascade);
  const Sums sums = tile.sums(digits);
  const FrameOnDevice on_device(test_device(), frame);
  for (int channel = 0; channel < 4; ++channel)
    for (int half = 0; half < 2; ++half) {
      GraphRunner runner(test_device(), compile(probe_graph(technique, half_of_channel(channel, half))));
      const std::vector<float> seen = runner.run(on_device, kOnce).visibility[0];
      const int columns = tile.side / step;
      for (int i = 0; i < int(seen.size()); ++i) {
        const int x = i % columns * step + step - 1, y = i / columns * step + step - 1;
        const std::uint32_t sum = sums[std::size_t(y * tile.side + x)][std::size_t(channel)];
        ASSERT_EQ(std::uint32_t(seen[std::size_t(i)]), sum >> 16 * half & 0xFFFFu)
            << technique << ", channel " << channel << " at " << x << ", " << y;
      }
    }
}

TEST(SummedAreas, OfDepthsAreThoseOfEveryTexelOfTheirTile) {
  for (const int cascade : {0, 3})
    expect_sums("vssm-sat-32", frame_of(64, 4, cascade, 1), cascade, 1, depth_digits);
}

// 96 texels are no multiple of what a group adds at a time.
TEST(SummedAreas, OfATileOfAnySide) {
  expect_sums("vssm-sat-32", frame_of(96, 1, 0, 1), 0, 1, depth_digits);
}

// Of 512 x 512 values of 16 bits most sums are beyond 2^32. Moments of depths with 5 places are farther from
// the middle between two steps than floats are wrong.
TEST(SummedAreas, OfMomentsAreExactModulo32Bits) {
  const scene::Frame frame = frame_of(1024, 4, 1, 16, 5);
  std::uint64_t largest = 0;
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 512; ++x) largest += moment_digits(Tile(frame, 1).centred(x, y))[0];
  ASSERT_GT(largest, std::uint64_t(1) << 32);
  expect_sums("mssm-sat-32", frame, 1, 16, moment_digits);
}

// The boxes have their edges anywhere, also beyond the tile's border. Their means are compared with sums over
// texels and the shares of them that the boxes have.
TEST(SummedAreas, GiveTheMeansOfBoxes) {
  const scene::Frame frame = frame_of(128, 4, 2, 3);
  const Tile tile(frame, 2);
  const FrameOnDevice on_device(test_device(), frame);
  const int columns = tile.side / 3;
  for (const double reach : {0.5, 0.8, 1.0, 2.3, 7.75, 20.0, 100.0}) {
    for (const int which : {0, 1}) {
      const std::string body =
          "    const TileBounds bounds = BoundsInTexels(tile);\n    const MapBox box = "
          "BoxInTile(floor(TexelCoordinates(receiver.shadowCoord.xy, tile)) + float2(0.75, 0.375), " +
          std::to_string(reach) +
          ", bounds);\n    return MomentsOfDigits(MeanOfBox(_PenumbraSumsTexture, box, bounds, "
          "kDepthDigitMiddle))[" +
          std::to_string(which) + "];\n";
      GraphRunner runner(test_device(), compile(probe_graph("vssm-sat-32", body)));
      const GraphResult result = runner.run(on_device, kCountedOnce);
      for (int i = 0; i < int(result.visibility[0].size()); ++i) {
        const double x = i % columns * 3 + 2.75, y = i / columns * 3 + 2.375;
        const double left = std::max(x - reach, 0.0), right = std::min(x + reach, double(tile.side));
        const double top = std::max(y - reach, 0.0), bottom = std::min(y + reach, double(tile.side));
        double sum = 0.0;
        for (int ty = 0; ty < tile.side; ++ty)
          for (int tx = 0; tx < tile.side; ++tx) {
            const double across = std::min(right, tx + 1.0) - std::max(left, double(tx));
            const double down = std::min(bottom, ty + 1.0) - std::max(top, double(ty));
            if (across <= 0.0 || down <= 0.0) continue;
            const double z = tile.centred(tx, ty);
            sum += static_cast<double>(across * down) * (which == 0 ? z : z * z);
          }
        const double mean = sum / ((right - left) * (bottom - top));
        // Depth 1/2 is stored a step nearer. The box's edges are floats near 64: they miss theirs by 2^-19,
        // of a width of 1 or more.
        const double edges = std::ldexp(4.0, -19) / std::min(2.0 * reach, right - left);
        ASSERT_NEAR(result.visibility[0][std::size_t(i)], mean, std::ldexp(3.0, -24) + edges)
            << "reach " << reach << ", moment " << which + 1 << " at " << x << ", " << y;
      }
      ASSERT_EQ(*std::max_element(result.fetches.begin(), result.fetches.end()), 16u);
    }
  }
}

// The means are of whole texels, in 4 fetches: nothing but the digits is rounded.
TEST(SummedAreas, GiveTheMeansOfWholeTexelsInFourFetches) {
  const scene::Frame frame = frame_of(128, 4, 1, 3);
  const Tile tile(frame, 1);
  const FrameOnDevice on_device(test_device(), frame);
  const int columns = tile.side / 3;
  for (const int reach : {1, 5, 40}) {
    const std::string body =
        "    const TileBounds bounds = BoundsInTexels(tile);\n    const TexelBox box = "
        "WholeTexels(BoxInTile(TexelCoordinates(receiver.shadowCoord.xy, tile), " +
        std::to_string(reach) +
        ".5, bounds));\n    return MomentsOfDigits(MeanOfTexels(_PenumbraSumsTexture, box, "
        "int2(bounds.minimum), "
        "kDepthDigitMiddle)).x;\n";
    GraphRunner runner(test_device(), compile(probe_graph("vssm-sat-32", body)));
    const GraphResult result = runner.run(on_device, kCountedOnce);
    for (int i = 0; i < int(result.visibility[0].size()); ++i) {
      const int x = i % columns * 3 + 2, y = i / columns * 3 + 2;
      double sum = 0.0;
      int count = 0;
      for (int ty = std::max(y - reach, 0); ty <= std::min(y + reach, tile.side - 1); ++ty)
        for (int tx = std::max(x - reach, 0); tx <= std::min(x + reach, tile.side - 1); ++tx, ++count)
          sum += tile.centred(tx, ty);
      ASSERT_NEAR(result.visibility[0][std::size_t(i)], sum / count, std::ldexp(2.0, -24)) << x << ", " << y;
    }
    EXPECT_THAT(result.fetches, testing::Each(4u));
  }
}

// Each level's texel is the mean of its box of the tile, rounded once per level.
TEST(MapLevels, AreMeansOfTheirTilesTexels) {
  constexpr int kCascade = 2;
  const scene::Frame frame = frame_of(128, 4, kCascade, 1);
  const Tile tile(frame, kCascade);
  const FrameOnDevice on_device(test_device(), frame);
  for (int level = 0; level <= 6; ++level) {
    const std::string text = std::to_string(level);
    GraphRunner runner(
        test_device(),
        compile(probe_graph("mssm-mip-16",
                            "    const float2 texels = TexelCoordinates(receiver.shadowCoord.xy, tile);\n"
                            "    return LOAD_TEXTURE2D_LOD(_PenumbraMomentsTexture, int2(texels) >> " +
                                text + ", " + text + ").y;\n")));
    const GraphResult result = runner.run(on_device, kCountedOnce);
    const int size = 1 << level;
    for (int y = 0; y < tile.side; y += size)
      for (int x = 0; x < tile.side; x += size) {
        double sum = 0.0;
        for (int i = 0; i < size * size; ++i) {
          const double z = 2.0 * tile.centred(x + i % size, y + i / size);
          sum += 4.0 * z * z - 4.0 * z * z * z * z;
        }
        ASSERT_NEAR(result.visibility[0][std::size_t(y * tile.side + x)], sum / (size * size),
                    (level + 1) * (0.51 / 65535.0) + 1e-6)
            << "level " << level << " at " << x << ", " << y;
      }
    // The first level reads and writes each texel, the others read four for each of theirs: 4/3 more.
    const double map = 128.0 * 128.0 / (tile.side * tile.side);
    EXPECT_DOUBLE_EQ(result.passes[0].fetches, map);
    EXPECT_NEAR(result.passes[1].fetches, 4.0 / 3.0 * map, 0.01 * map);
    EXPECT_NEAR(result.passes[1].texels_written, map / 3.0, 0.01 * map);
  }
}

TEST(SummedAreas, CostThreeFetchesPerTexelOfTheMap) {
  const scene::Frame frame = frame_of(64, 4, 0, 1);
  const techniques::TechniqueList& list = library_techniques();
  GraphRunner runner(test_device(), compile(technique_graph(list, list.find("mssm-sat-32"))));
  const GraphResult result = runner.run(FrameOnDevice(test_device(), frame), kCountedOnce);
  ASSERT_EQ(result.passes.size(), 4u);
  for (int pass = 0; pass < 3; ++pass) {
    EXPECT_DOUBLE_EQ(result.passes[std::size_t(pass)].fetches, 4.0)
        << "four tiles, receivers at one's texels";
    EXPECT_DOUBLE_EQ(result.passes[std::size_t(pass)].texels_written, 4.0);
  }
}

}  // namespace
}  // namespace penumbra::resolve
