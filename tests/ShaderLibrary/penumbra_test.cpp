// Core/Penumbra.hlsl: radii by similar triangles, shares exact at both ends, nothing unbounded.
#include <algorithm>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// A light of any angular diameter from 0.01 to 30 degrees shines on a tile: extent, atlas width, uv and depth
// per metre, depth to radial and its inverse.
constexpr const char* kScales =
    "ShadowTile tile; tile.offsetScale = float4(0, 0, In(0), In(0)); tile.atlasTexelSize = float4(0, 0, "
    "In(1), In(1)); tile.uvPerMetre = In(2); tile.depthPerMetre = In(3); tile.depthToRadial = In(4); "
    "tile.radialToDepth = In(5); const ConeScales scales = ConeScalesOf(tile);";
constexpr int kTileWords = 6;
constexpr std::size_t kSetupWords = 10;  // tile, and four words of the setup

void append_tile(std::vector<float>& inputs, Random& random) {
  const float uv_per_metre = std::pow(10.0f, random.between(-3.0f, 0.0f));
  const float depth_per_metre = std::pow(10.0f, random.between(-4.0f, -1.0f));
  const float tan_half = std::tan(0.5f * 0.0174533f * std::pow(10.0f, random.between(-2.0f, 1.47f)));
  const float to_radial = tan_half * uv_per_metre / depth_per_metre;
  inputs.insert(inputs.end(),
                {random.integer(0, 1) == 0 ? 1.0f : 0.5f, std::exp2(float(random.integer(8, 13))),
                 uv_per_metre, depth_per_metre, to_radial, 1.0f / to_radial});
}

long double tile_texels(const float* in) {
  return static_cast<long double>(in[0]) * in[1];
}

// The scales are products and one division, 2.5 ULP in Vulkan.
TEST(ConeScales, AreTheTilesScalesPerTexel) {
  Random random(25);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) append_tile(inputs, random);
  expect_exact(
      {"Penumbra",
       std::string(kScales) +
           "Out(0, scales.texelsPerDepth); Out(1, scales.depthPerTexel); Out(2, scales.texelsPerMetre); "
           "Out(3, scales.depthPerMetre); Out(4, scales.largestRadius);",
       kTileWords, 5},
      inputs,
      [](const float* in) {
        const long double texels = tile_texels(in);
        return std::vector<Exact>{{in[4] * texels}, {in[5] / texels}, {in[2] * texels}, {in[3]}, {texels}};
      },
      2.5L);
}

// LargestGap, PenumbraRadius and SearchRadius have at most four roundings in a row.
TEST(PenumbraRadius, FollowsSimilarTriangles) {
  for (const DepthDirection direction : kDepthDirections) {
    Random random(26);
    std::vector<float> inputs;
    for (int i = 0; i < kRandomCases; ++i) {
      append_tile(inputs, random);
      // The inputs are gap, receiver depth, largest penumbra in metres and floor in texels.
      inputs.insert(inputs.end(), {random.between(-0.1f, 1.0f), random.between(0.0f, 1.0f),
                                   std::pow(10.0f, random.between(-2.0f, 3.0f)), random.between(0.0f, 2.0f)});
    }
    expect_exact(
        {"Penumbra",
         std::string(kScales) +
             "Out(0, PenumbraRadius(In(6), scales)); Out(1, SearchRadius(In(7), In(8), In(9), scales));",
         kTileWords + 4, 2},
        direction, inputs,
        [=](const float* in) {
          const long double texels = tile_texels(in);
          const long double radius = std::min(std::max(in[6] + 0.0L, 0.0L) * in[4] * texels, texels);
          const long double nearest = direction == DepthDirection::reversed ? 1.0L - in[7] : in[7] + 0.0L;
          const long double cone = std::min(nearest * in[4], 1.0L) * texels;
          const long double search = std::min(cone, 0.5L * in[8] * in[2] * texels);
          return std::vector<Exact>{{radius}, {std::clamp(search, in[9] + 0.0L, texels)}};
        },
        3.0L);
  }
}

// The difference is exact or rounds at the size of the radius.
TEST(ConeOffset, RisesFromTheSlackToItsCap) {
  Random random(27);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    append_tile(inputs, random);
    inputs.insert(inputs.end(),
                  {random.between(0.0f, 100.0f), random.between(0.0f, 2.0f), random.between(0.0f, 1.0f)});
  }
  expect_exact(
      {"Penumbra", std::string(kScales) + "Out(0, ConeOffset(In(6), In(7), In(8), scales));", kTileWords + 3,
       1},
      inputs,
      [](const float* in) {
        const long double per_texel = in[5] / tile_texels(in);
        const long double offset = std::max(in[6] - static_cast<long double>(in[7]), 0.0L) * per_texel;
        return std::vector<Exact>{{std::min(offset, in[8] + 0.0L), std::max(in[6] * per_texel, 1e-30L)}};
      },
      4.0L);
}

TEST(Penumbra, RadiiAndOffsetsAreFiniteForAnyTile) {
  Random random(28);
  std::vector<float> inputs(kSetupWords * kRandomCases);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    inputs[i] = i % 3 == 0 ? random.any_bits() : random.magnitude(-8.0f, 8.0f);
    if (i % kSetupWords >= kSetupWords - 4) inputs[i] = random.between(0.0f, 1.0f);
    if (i % kSetupWords == kSetupWords - 2) inputs[i] = random.any_bits();
  }
  expect_within(
      {"Penumbra",
       std::string(kScales) + "Out(0, PenumbraRadius(In(6), scales)); Out(1, SearchRadius(In(7), In(8), "
                              "In(9), scales)); Out(2, ConeOffset(In(6), In(7), In(9), scales));",
       kTileWords + 4, 3},
      inputs, 0.0f, 65536.0f);
}

// The result is one division, 2.5 ULP.
TEST(AverageGap, DividesOnlyByWhatWasWeighed) {
  Random random(29);
  std::vector<float> inputs = {0.0f, 0.0f, 1.0f, 0.0f};
  while (inputs.size() < 2 * std::size_t(kRandomCases))
    inputs.insert(inputs.end(), {random.between(0.0f, 64.0f), random.between(0.0f, 64.0f)});
  expect_exact(
      {"Penumbra", "Out(0, AverageGap(In(0), In(1)));", 2, 1}, inputs,
      [](const float* in) {
        return std::vector<Exact>{{in[1] > 0.0f ? static_cast<long double>(in[0]) / in[1] : 0.0L}};
      },
      2.5L);
}

// The share is a sum and a division; where one side is exactly zero, nothing is rounded at all.
TEST(LitShare, IsExactWhereAllOrNothingIsLit) {
  Random random(30);
  std::vector<float> inputs = {0.0f, 0.0f};
  for (int i = 0; i < kRandomCases; ++i) {
    inputs.insert(inputs.end(), {i % 3 == 0 ? 0.0f : random.between(0.0f, 64.0f),
                                 i % 3 == 1 ? 0.0f : random.between(0.0f, 64.0f)});
  }
  const CoreFunction share{"Penumbra", "Out(0, LitShare(In(0), In(1)));", 2, 1};
  expect_exact(
      share, inputs,
      [](const float* in) {
        const long double sum = static_cast<long double>(in[0]) + in[1];
        return std::vector<Exact>{{sum > 0.0L ? in[0] / sum : 1.0L}};
      },
      3.0L);
  const std::vector<float> results = run(share, inputs);
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (inputs[2 * i + 1] == 0.0f) {
      ASSERT_EQ(results[i], 1.0f);
    } else if (inputs[2 * i] == 0.0f) {
      ASSERT_EQ(results[i], 0.0f);
    }
  }
}

TEST(MeanVisibility, IsExactlyOneForEveryCountFullyLit) {
  const std::vector<float> inputs = random_cases(31, [&](Random& random, int i) {
    const float count = float(random.integer(1, 4096));
    return Case{i % 3 == 0 ? count : i % 3 == 1 ? 0.0f : random.between(0.0f, count), count};
  });
  const CoreFunction mean{"Penumbra", "Out(0, MeanVisibility(In(0), In(1)));", 2, 1};
  expect_exact(
      mean, inputs,
      [](const float* in) { return std::vector<Exact>{{static_cast<long double>(in[0]) / in[1]}}; }, 2.5L);
  const std::vector<float> results = run(mean, inputs);
  for (std::size_t i = 0; i < results.size(); i += 3) ASSERT_EQ(results[i], 1.0f) << inputs[2 * i];
  for (std::size_t i = 1; i < results.size(); i += 3) ASSERT_EQ(results[i], 0.0f) << inputs[2 * i + 1];
}

}  // namespace
}  // namespace penumbra::shader_library_tests
