// Compares upsampling and denoising through the package's .shader with the same filters written here in
// double, over planes, depth edges, sky and rubbish.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <random>

#include "resolve/pass_runner.h"

namespace penumbra::resolve {
namespace {

constexpr glm::dvec3 kTilted(0.3, 0.8, -0.52);

HandImage plane(int width, int height, const glm::dvec3& normal, double distance) {
  HandImage depth = filled(width, height, 0.0f);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double z = HandCamera::on_plane(normal, distance, x, y, width, height);
      if (z > HandCamera::kNear && z < HandCamera::kFar) depth.at(x, y) = HandCamera::stored(z);
    }
  }
  return depth;
}

// One wall is 2 m away left of `column`, another 20 m away from there on.
HandImage two_walls(int width, int height, int column) {
  HandImage depth = filled(width, height, HandCamera::stored(20.0));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < column; ++x) depth.at(x, y) = HandCamera::stored(2.0);
  }
  return depth;
}

HandImage random_image(int width, int height, std::uint32_t seed, float low = 0.0f, float high = 1.0f) {
  std::mt19937 engine(seed);
  HandImage image = filled(width, height, 0.0f);
  for (float& texel : image.texels) texel = std::uniform_real_distribution<float>(low, high)(engine);
  return image;
}

HandImage with_rubbish(HandImage image, std::uint32_t seed) {
  std::mt19937 engine(seed);
  const float rubbish[] = {std::numeric_limits<float>::quiet_NaN(),
                           -std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity(),
                           -3.0f,
                           5.0f,
                           0.0f,
                           1.0f};
  for (float& texel : image.texels) {
    if (engine() % 3 == 0) texel = rubbish[engine() % 8];
  }
  return image;
}

int half(int size) {
  return (size + 1) / 2;
}

class Upsample : public testing::Test {
 protected:
  static PassRunner& pass() {
    static KeptOnDevice<std::optional<PassRunner>> runner;
    return *runner ? **runner : runner->emplace("Resolve");
  }
  static PassAnswer run(const HandImage& depth, const HandImage& halved) {
    return pass().run(depth, halved, depth.width, depth.height);
  }
};

// The full pixel that a half pixel saw.
int seen(int pixel, int size) {
  return std::min(2 * pixel + 1, size - 1);
}

// The taps are the half pixels that saw the nearest places: on one plane every tap counts the same.
std::vector<float> taps_around(const HandImage& halved, int x, int y, int width, int height) {
  const auto around = [](int full, int size, int full_size) {
    // The last half pixel saw the last pixel, or the one before it.
    if (full == full_size - 1) return std::vector<int>{size - 1};
    std::vector<int> pixels;
    for (const int pixel : {(full + 1) / 2 - 1, full / 2}) {
      const bool known = !pixels.empty() && pixels.back() == pixel;
      if (pixel >= 0 && pixel < size && !known) pixels.push_back(pixel);
    }
    return pixels;
  };
  std::vector<float> taps;
  for (const int i : around(x, halved.width, width)) {
    for (const int j : around(y, halved.height, height)) taps.push_back(halved.at(i, j));
  }
  return taps;
}

// Where taps differ by more than this, the pass computes the pixel. It is lit, as no shadow map is bound
// here.
constexpr double kStep = 0.25;
constexpr float kComputed = 1.0f;

// The mean of the taps, or what the pass computes; nothing where rounding decides which.
std::optional<float> on_one_plane(const HandImage& halved, int x, int y, int width, int height) {
  const std::vector<float> taps = taps_around(halved, x, y, width, height);
  const auto [lowest, highest] = std::minmax_element(taps.begin(), taps.end());
  const double range = double{*highest} - *lowest;
  if (std::abs(range - kStep) < 1e-4) return std::nullopt;
  if (range > kStep) return kComputed;
  return static_cast<float>(std::accumulate(taps.begin(), taps.end(), 0.0) /
                            static_cast<double>(taps.size()));
}

TEST_F(Upsample, InterpolatesOverAPlaneWhatIsCloseAndCopiesWhatWasSeen) {
  int interpolated = 0;
  int computed = 0;
  for (const auto& [width, height] :
       {std::pair(33, 20), std::pair(20, 33), std::pair(2, 2), std::pair(1, 1)}) {
    const HandImage depth = plane(width, height, {0.1, 0.2, -1.0}, 5.0);
    const HandImage halved = random_image(half(width), half(height), 71);
    const PassAnswer answer = run(depth, halved);
    EXPECT_THAT(answer.written, testing::Each(1));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if ((x % 2 == 1 || x == width - 1) && (y % 2 == 1 || y == height - 1)) {
          ASSERT_EQ(answer.image.at(x, y), halved.at(x / 2, y / 2));
          ASSERT_EQ(answer.fetches[static_cast<std::size_t>(y * width + x)], 1);
        }
        const std::optional<float> expected = on_one_plane(halved, x, y, width, height);
        if (!expected) continue;
        ++(*expected == kComputed ? computed : interpolated);
        ASSERT_NEAR(answer.image.at(x, y), *expected, 2e-3) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(interpolated, 300);
  EXPECT_GT(computed, 300);
}

TEST_F(Upsample, DoesNotBleedOverDepthEdges) {
  const int width = 41;
  const int height = 17;
  for (const int column : {10, 11, 20, 31}) {
    const HandImage depth = two_walls(width, height, column);
    HandImage halved = filled(half(width), half(height), 1.0f);
    for (int y = 0; y < halved.height; ++y) {
      for (int x = 0; x < halved.width; ++x) halved.at(x, y) = seen(x, width) < column ? 0.0f : 1.0f;
    }
    const PassAnswer answer = run(depth, halved);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x)
        ASSERT_EQ(answer.image.at(x, y), x < column ? 0.0f : 1.0f) << x << ", " << y;
    }
  }
}

TEST_F(Upsample, ComputesAPixelWhereNoTapIsOfItsSurface) {
  // A leaf of one pixel is seen by no half pixel, has sky beside it and four surfaces at its corners, one of
  // them near.
  for (const int near_corner : {0, 1, 2, 3}) {
    HandImage depth = filled(16, 16, 0.0f);
    HandImage halved = filled(8, 8, 0.0f);
    depth.at(6, 6) = HandCamera::stored(3.0);
    for (int corner = 0; corner < 4; ++corner) {
      const int x = corner % 2;
      const int y = corner / 2;
      depth.at(5 + 2 * x, 5 + 2 * y) = HandCamera::stored(corner == near_corner ? 3.5 : 30.0);
      halved.at(2 + x, 2 + y) = corner == near_corner ? 0.75f : 0.125f * float(corner);
    }
    EXPECT_EQ(run(depth, halved).image.at(6, 6), kComputed) << near_corner;
  }
}

TEST_F(Upsample, AgreementIsCopiedAndCostsNoDepth) {
  const HandImage depth = with_rubbish(two_walls(30, 14, 9), 5);
  const PassAnswer answer = run(depth, filled(15, 7, 0.375f));
  EXPECT_THAT(answer.image.texels, testing::Each(0.375f));
  for (int y = 0; y < 14; ++y) {
    for (int x = 0; x < 30; ++x) {
      const int taps = (x % 2 == 1 || x == 0 ? 1 : 2) * (y % 2 == 1 || y == 0 ? 1 : 2);
      ASSERT_EQ(answer.fetches[static_cast<std::size_t>(y * 30 + x)], taps) << x << ", " << y;
    }
  }
}

TEST_F(Upsample, StaysInRangeWhateverItReads) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const HandImage depth = with_rubbish(plane(37, 23, kTilted, 6.0), seed);
    const PassAnswer answer = run(depth, with_rubbish(random_image(19, 12, seed), seed + 100));
    EXPECT_THAT(answer.image.texels, testing::Each(testing::AllOf(testing::Ge(0.0f), testing::Le(1.0f))));
  }
}

UniformValues denoise_params(float radius, float tolerance = 2.0f, float amplitude = 0.25f) {
  UniformValues values;
  values.set("_PenumbraDenoiseParameters0", glm::vec4(radius, tolerance, amplitude, 0.0f));
  return values;
}

struct Direction {
  const char* pass;
  int x;
  int y;
};

void PrintTo(const Direction& value, std::ostream* stream) {
  *stream << value.pass;
}

class Denoise : public testing::TestWithParam<Direction> {
 protected:
  static PassAnswer run(const HandImage& depth, const HandImage& source, const UniformValues& params) {
    static KeptOnDevice<std::map<std::string, std::unique_ptr<PassRunner>>> runners;
    std::unique_ptr<PassRunner>& runner = (*runners)[GetParam().pass];
    if (runner == nullptr) runner = std::make_unique<PassRunner>(GetParam().pass);
    return runner->run(depth, source, depth.width, depth.height, params);
  }
  static bool inside(const HandImage& image, int x, int y, int steps) {
    return image.has(x + steps * GetParam().x, y + steps * GetParam().y);
  }
  static float beside(const HandImage& image, int x, int y, int steps) {
    return image.at(x + steps * GetParam().x, y + steps * GetParam().y);
  }
};

TEST_P(Denoise, IsTheWeightedMeanOverAPlane) {
  const HandImage depth = plane(48, 31, kTilted, 6.0);
  const HandImage source = random_image(48, 31, 72, 0.2f, 0.8f);
  for (const int radius : {0, 1, 2, 5, 8}) {
    const PassAnswer answer = run(depth, source, denoise_params(float(radius)));
    for (int y = 0; y < 31; ++y) {
      for (int x = 0; x < 48; ++x) {
        if (depth.at(x, y) == 0.0f) {
          ASSERT_EQ(answer.image.at(x, y), source.at(x, y)) << "sky is left alone";
          continue;
        }
        const double here = source.at(x, y);
        double sum = 0.0;
        double weights = 0.0;
        for (int i = -radius; i <= radius; ++i) {
          if (!inside(source, x, y, i) || beside(depth, x, y, i) == 0.0f) continue;
          const double there = beside(source, x, y, i);
          const double alike = std::max(0.0, 1.0 - std::abs(there - here) / 0.25);
          sum += (radius + 1 - std::abs(i)) * alike * there;
          weights += (radius + 1 - std::abs(i)) * alike;
        }
        // Depths of a plane are a straight line to their rounding, which takes a little of a weight.
        ASSERT_NEAR(answer.image.at(x, y), sum / weights, 2e-3) << radius << ": " << x << ", " << y;
      }
    }
  }
}

TEST_P(Denoise, EndsStayExactWhereTheNeighbourhoodIsOneAndCostNoDepth) {
  const int radius = 3;
  HandImage source = filled(40, 40, 1.0f);
  std::mt19937 engine(73);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      if (x + y > 50) source.at(x, y) = 0.0f;
      if (x + y > 20 && x + y < 30) source.at(x, y) = float(engine() % 17) / 16.0f;
    }
  }
  const PassAnswer answer = run(plane(40, 40, {0.0, 0.3, -1.0}, 4.0), source, denoise_params(float(radius)));
  int settled = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      bool one = true;
      int reads = 0;
      for (int i = -radius; i <= radius; ++i) {
        if (!inside(source, x, y, i)) continue;
        ++reads;
        one = one && beside(source, x, y, i) == source.at(x, y);
      }
      if (!one || (source.at(x, y) != 0.0f && source.at(x, y) != 1.0f)) continue;
      ++settled;
      ASSERT_EQ(answer.image.at(x, y), source.at(x, y)) << x << ", " << y;
      ASSERT_EQ(answer.fetches[static_cast<std::size_t>(y * 40 + x)], reads) << x << ", " << y;
    }
  }
  EXPECT_GT(settled, 600);
}

TEST_P(Denoise, KeepsTheShadowsOwnEdges) {
  HandImage source = filled(32, 32, 0.25f);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      if (x + y > 31) source.at(x, y) = 0.75f;
    }
  }
  const PassAnswer answer = run(plane(32, 32, {0.0, 0.0, -1.0}, 4.0), source, denoise_params(4.0f));
  EXPECT_EQ(answer.image.texels, source.texels);
}

TEST_P(Denoise, DoesNotMixSurfaces) {
  for (const int edge : {7, 8, 16, 30}) {
    HandImage depth = filled(32, 32, HandCamera::stored(20.0));
    HandImage source = filled(32, 32, 0.5f);
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 32; ++x) {
        if (x * GetParam().x + y * GetParam().y >= edge) continue;
        depth.at(x, y) = HandCamera::stored(2.0);
        source.at(x, y) = 0.375f;  // near enough to count as noise, were it the same surface
      }
    }
    const PassAnswer answer = run(depth, source, denoise_params(4.0f));
    EXPECT_EQ(answer.image.texels, source.texels) << edge;
  }
}

TEST_P(Denoise, TheRadiusIsBounded) {
  const HandImage depth = plane(40, 40, {0.0, 0.3, -1.0}, 4.0);
  const HandImage source = random_image(40, 40, 74, 0.3f, 0.6f);
  const std::vector<float> largest = run(depth, source, denoise_params(8.0f)).image.texels;
  EXPECT_EQ(run(depth, source, denoise_params(1e6f)).image.texels, largest);
  EXPECT_EQ(run(depth, source, denoise_params(-3.0f)).image.texels, source.texels);
  EXPECT_NE(run(depth, source, denoise_params(7.0f)).image.texels, largest);
}

TEST_P(Denoise, StaysInRangeWhateverItReads) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const HandImage depth = with_rubbish(plane(37, 23, kTilted, 6.0), seed);
    const HandImage source = with_rubbish(random_image(37, 23, seed), seed + 50);
    for (const float amplitude : {0.25f, 0.0f, -1.0f, 1e30f}) {
      const PassAnswer answer = run(depth, source, denoise_params(3.0f, 2.0f, amplitude));
      EXPECT_THAT(answer.image.texels, testing::Each(testing::AllOf(testing::Ge(0.0f), testing::Le(1.0f))));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Package, Denoise,
                         testing::Values(Direction{"DenoiseHorizontal", 1, 0},
                                         Direction{"DenoiseVertical", 0, 1}),
                         [](const auto& instance) { return std::string(instance.param.pass); });

}  // namespace
}  // namespace penumbra::resolve
