// Screen/PenumbraMask.hlsl and the reach of Screen/MaskBlur.hlsl: taps, the test, and how far a penumbra can
// come.
#include <algorithm>
#include <set>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

TEST(PenumbraMask, TapsAreFourPixelsOfTheBlockInDifferentRowsAndColumns) {
  std::vector<float> inputs;
  for (int block_x = 0; block_x < 30; ++block_x) {
    for (int block_y = 0; block_y < 17; ++block_y) {
      for (int tap = 0; tap < 4; ++tap)
        inputs.insert(inputs.end(), {float(block_x), float(block_y), float(tap)});
    }
  }
  // The last blocks of 119 x 66 pixels are cut off.
  const std::vector<float> results =
      run({"../Screen/PenumbraMask",
           "const int2 p = MaskTapPixel(int2(InInt(0), InInt(1)), InInt(2), int2(119, 66)); OutInt(0, p.x); "
           "OutInt(1, p.y); OutInt(2, MaskBlockOf(p).x); OutInt(3, MaskBlockOf(p).y);",
           3, 4},
          inputs);
  for (std::size_t i = 0; i < inputs.size() / 12; ++i) {
    std::set<float> columns;
    std::set<float> rows;
    for (std::size_t tap = 0; tap < 4; ++tap) {
      const float* in = &inputs[12 * i + 3 * tap];
      const float* got = &results[16 * i + 4 * tap];
      ASSERT_EQ(got[2], in[0]);
      ASSERT_EQ(got[3], in[1]);
      ASSERT_LT(got[0], 119.0f);
      ASSERT_LT(got[1], 66.0f);
      columns.insert(got[0]);
      rows.insert(got[1]);
    }
    const bool whole = inputs[12 * i] < 29.0f && inputs[12 * i + 1] < 16.0f;
    ASSERT_TRUE(!whole || columns.size() + rows.size() == 8);
  }
}

TEST(PenumbraMask, IsOneUnlessAllTapsAreAtOneEnd) {
  const std::vector<float> ends{0.0f, 1.0f, 0.5f, 1.0f / 256.0f, 255.0f / 256.0f, 1.0f / 1024.0f, 0.9999f};
  std::vector<float> inputs;
  for (std::size_t i = 0; i < ends.size() * ends.size() * ends.size() * ends.size(); ++i) {
    std::size_t rest = i;
    for (int k = 0; k < 4; ++k) {
      inputs.push_back(ends[rest % ends.size()]);
      rest /= ends.size();
    }
  }
  const std::vector<float> results = run({"../Screen/PenumbraMask", "Out(0, MaskOf(In4(0)));", 4, 1}, inputs);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto taps = inputs.begin() + static_cast<std::ptrdiff_t>(4 * i);
    const auto [lowest, highest] = std::minmax_element(taps, taps + 4);
    // A hardware filter's smallest share is 1/256, so a value that is nearer to an end than half of that is
    // the end.
    const bool one_end = *highest <= 1.0f / 512.0f || *lowest >= 511.0f / 512.0f;
    ASSERT_EQ(results[i], one_end ? 0.0f : 1.0f);
  }
}

// The tile has 1024 texels of an atlas of 2048, then uvPerMetre, depthPerMetre and tan(a/2); the mask has
// penumbra, texels and bound.
const std::string kReach =
    "ShadowTile tile; tile.offsetScale = float4(0.5, 0.0, 0.5, 0.5); tile.atlasTexelSize = float4(1.0 / "
    "2048.0, 1.0 / 2048.0, 2048.0, 2048.0); tile.uvPerMetre = In(1); tile.depthPerMetre = In(2); "
    "tile.depthToRadial = In(3) * In(1) / In(2); tile.radialToDepth = In(3) > 0.0 ? In(2) / (In(3) * In(1)) "
    ": 0.0; MaskParameters mask; mask.maskPenumbraMetres = In(4); mask.maskFilterTexels = In(5); "
    "mask.maskLargestRadius = 24; const float reach = MaskReachMetres(In(0), tile, mask);";

std::vector<float> random_receivers() {
  Random random(81);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    inputs.insert(
        inputs.end(),
        {random.between(0.0f, 1.0f), 1.0f / random.between(2.0f, 300.0f), 1.0f / random.between(5.0f, 500.0f),
         random.integer(0, 9) == 0 ? 0.0f : random.between(0.002f, 0.1f), random.between(0.0f, 5.0f),
         random.between(0.0f, 4.0f), random.between(0.001f, 0.5f)});
  }
  return inputs;
}

// The reach is in metres from the start: the gap to the map's near plane times the tangent, or half the cap,
// but not below the kernel.
long double reach_of(const float* in, DepthDirection direction) {
  const long double to_near_plane =
      (direction == DepthDirection::reversed ? 1.0L - in[0] : static_cast<long double>(in[0])) / in[2];
  const long double of_light = std::min(in[3] * to_near_plane, 0.5L * in[4]);
  const long double texel = 1.0L / in[1] / 1024.0L;
  return std::min(std::max(of_light, in[5] * texel), 1024.0L * texel);
}

TEST(PenumbraMask, ReachIsTheWidestPenumbraOrTheKernel) {
  for (const DepthDirection direction : kDepthDirections) {
    expect_exact(
        {"../Screen/MaskBlur", kReach + "Out(0, reach);", 7, 1}, direction, random_receivers(),
        [direction](const float* in) {
          const long double reach = reach_of(in, direction);
          return std::vector<Exact>{{reach, std::max(reach, static_cast<long double>(in[3]) / in[2])}};
        },
        16.0L);
  }
}

TEST(PenumbraMask, RadiusIsTheReachInBlocksRoundedUpAndGrowsTowardTheCamera) {
  const std::vector<float> inputs = random_receivers();
  const std::vector<float> results = run(
      {"../Screen/MaskBlur",
       kReach + "OutInt(0, MaskRadius(reach, In(6), mask)); OutInt(1, MaskRadius(reach, 0.5 * In(6), mask));",
       7, 2},
      DepthDirection::reversed, inputs);
  for (std::size_t i = 0; i < inputs.size() / 7; ++i) {
    const float* in = &inputs[7 * i];
    const long double blocks = reach_of(in, DepthDirection::reversed) / (4.0L * in[6]);
    const float at = results[2 * i];
    ASSERT_GE(at, std::min(24.0L, std::ceil(blocks * 0.99999L)));
    ASSERT_LE(at, std::min(24.0L, std::ceil(blocks * 1.00001L)));
    ASSERT_GE(results[2 * i + 1], at) << "half as far away";
  }
}

TEST(PenumbraMask, RadiusIsBoundedWhateverItIsGiven) {
  Random random(82);
  expect_within({"../Screen/MaskBlur", kReach + "OutInt(0, MaskRadius(reach, In(6), mask));", 7, 1},
                random_special_floats(random, 7 * kRandomCases), 0.0f, 24.0f);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
