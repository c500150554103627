// Screen/PenumbraSmoothing.hlsl against the same mean in long double, and the cases that must not change.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr int kTaps = 8;
constexpr int kWords = 3 * (kTaps + 1);  // visibility, radius and depth of the pixel and of each tap

struct Pixel {
  float visibility, radius, depth;
};
using Pixels = std::array<Pixel, kTaps + 1>;  // the first is the pixel itself

// Returns visibility, radius and whether there is noise, by the reach of the nearest pixels.
std::vector<float> smoothed(const std::vector<Pixels>& cases) {
  std::vector<float> inputs;
  for (const Pixels& pixels : cases)
    for (const Pixel& pixel : pixels) {
      inputs.push_back(pixel.visibility);
      inputs.push_back(pixel.radius);
      inputs.push_back(pixel.depth);
    }
  return run(
      function_in("Screen", "PenumbraSmoothing",
                  "SmoothingTaps t; NoisyVisibility v; v.visibility = In(0); v.radius = In(1); t.here = "
                  "PackNoisy(v); t.depth = In(2); for (int i = 0; i < SMOOTHING_TAPS; ++i) { v.visibility = "
                  "In(3 * i + 3); v.radius = In(3 * i + 4); t.words[i] = PackNoisy(v); t.depths[i] = In(3 * "
                  "i + 5); } const NoisyVisibility s = SmoothPenumbra(t, NearSmoothing()); Out(0, "
                  "s.visibility); Out(1, s.radius); Out(2, HasNoise(t) ? 1.0 : 0.0);",
                  kWords, 3),
      inputs);
}

// The mean as the file's head describes it, with the constants of NearSmoothing().
std::array<long double, 2> expected(const Pixels& pixels) {
  const Pixel& here = pixels[0];
  std::vector<long double> pairs;
  long double radius = here.radius, lowest = 1.0L, highest = 0.0L;
  for (std::size_t i = 1; i < pixels.size(); i += 2) {
    const long double after = static_cast<long double>(pixels[i].depth) - here.depth;
    const long double before = static_cast<long double>(here.depth) - pixels[i + 1].depth;
    if (!(std::abs(after - before) < 0.125L * std::abs(after + before) + 0.001L * here.depth)) continue;
    pairs.push_back((static_cast<long double>(pixels[i].visibility) + pixels[i + 1].visibility) / 2.0L);
    for (const std::size_t k : {i, i + 1}) {
      radius = std::max<long double>(radius, pixels[k].radius);
      lowest = std::min<long double>(lowest, pixels[k].visibility);
      highest = std::max<long double>(highest, pixels[k].visibility);
    }
  }
  const long double share = std::clamp((radius - 0.5L) / 1.5L, 0.0L, 1.0L);
  long double own = here.visibility;
  if (!pairs.empty()) own += share * (std::clamp(own, lowest, highest) - own);
  long double sum = own, weights = 1.0L;
  for (const long double pair : pairs) {
    const long double weight = 2.0L * share * std::max(1.0L - std::abs(pair - own) / 0.3L, 0.0L);
    sum += weight * pair;
    weights += weight;
  }
  return {sum / weights, radius};
}

Pixels random_pixels(Random& random, int kind) {
  Pixels pixels;
  const float depth = random.between(0.001f, 0.9f);
  const float slope = kind % 3 == 0 ? 0.0f : depth * random.between(-0.05f, 0.05f);
  const float visibility = random.between(0.0f, 1.0f);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const float along = i == 0 ? 0.0f : i % 2 == 1 ? 1.0f : -1.0f;
    pixels[i].depth = depth + along * slope;
    if (kind % 3 == 2 && i > 4) pixels[i].depth = random.between(0.0f, 1.0f);
    pixels[i].visibility = std::clamp(visibility + random.between(-0.4f, 0.4f), 0.0f, 1.0f);
    // Halves hold these numbers exactly.
    pixels[i].radius = static_cast<float>(static_cast<int>(random.between(0.0f, 12.0f))) * 0.25f;
  }
  return pixels;
}

TEST(PenumbraSmoothing, IsTheMeanOfPairsInTheSurfaceThatDifferNoMoreThanNoise) {
  Random random(97);
  std::vector<Pixels> cases;
  for (int i = 0; i < kRandomCases; ++i) cases.push_back(random_pixels(random, i));
  const std::vector<float> out = smoothed(cases);
  int changed = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto [visibility, radius] = expected(cases[i]);
    // Sixteen bits of visibility, whose differences are divided by 0.3.
    ASSERT_NEAR(out[3 * i], static_cast<double>(visibility), 1e-4) << i;
    ASSERT_EQ(out[3 * i + 1], static_cast<float>(radius)) << i;
    changed += std::fabs(out[3 * i] - cases[i][0].visibility) > 0.01f ? 1 : 0;
  }
  EXPECT_GT(changed, kRandomCases / 3);
}

// Pixels of the same visibility have no noise, whatever their surfaces and penumbrae.
TEST(PenumbraSmoothing, ChangesNothingWhereNothingDiffers) {
  Random random(98);
  std::vector<Pixels> cases;
  for (int i = 0; i < kRandomCases; ++i) {
    Pixels pixels = random_pixels(random, i);
    for (Pixel& pixel : pixels) pixel.visibility = pixels[0].visibility;
    cases.push_back(pixels);
  }
  const std::vector<float> out = smoothed(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    ASSERT_EQ(out[3 * i + 2], 0.0f) << i;
    ASSERT_NEAR(out[3 * i], cases[i][0].visibility, 1e-5) << i;
  }
}

// Where visibility rises by 0.4 from pixel to pixel, more than the amplitude, an even rise stays as it is,
// and the pixel's own noise is smoothed.
TEST(PenumbraSmoothing, SmoothsAcrossASteepPenumbraAndKeepsIt) {
  Pixels ramp;
  const float rises[] = {0.0f, 0.4f, -0.4f, 0.0f, 0.0f, 0.4f, -0.4f, 0.4f, -0.4f};
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = {0.5f + rises[i], 4.0f, 0.25f};
  Pixels noisy = ramp;
  noisy[0].visibility = 0.56f;
  const std::vector<float> out = smoothed({ramp, noisy});
  EXPECT_NEAR(out[0], 0.5f, 1e-4f);
  // Each pair's mean differs by 0.06, a fifth of the amplitude, so each of the four weighs 1.6.
  EXPECT_NEAR(out[3], 0.5f + 0.06f / (1.0f + 4.0f * 1.6f), 1e-4f);
}

// Neither the shadow of another surface nor an edge of the shadow is mixed into a pixel, but a pixel that
// stands out from all around it is brought back.
TEST(PenumbraSmoothing, KeepsEdgesOfSurfacesAndOfShadowsAndNoSinglePixels) {
  Pixels step, hard, single;
  for (std::size_t i = 0; i < step.size(); ++i) {
    const bool other = i % 2 == 1;
    step[i] = {other ? 0.6f : 0.5f, 4.0f, other ? 0.2f : 0.25f};
    hard[i] = {other ? 0.0f : 1.0f, 4.0f, 0.25f};
    single[i] = {i == 0 ? 1.0f : 0.25f, 4.0f, 0.25f};
  }
  const std::vector<float> out = smoothed({step, hard, single});
  EXPECT_NEAR(out[0], 0.5f, 1e-5f);
  EXPECT_EQ(out[3], 1.0f);
  EXPECT_NEAR(out[6], 0.25f, 1e-5f);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
