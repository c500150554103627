// The conclusions of Filters/SingleLoop/SingleLoopRanges.hlsl from a range hold for every texel in it,
// however the receiver's plane lies; and so does the exit for surfaces that face away.
#include <algorithm>
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr int kReceivers = 1000000;

// The inputs are range, receiver's depth, gradient and reach, then a texel of the range and the tap that
// reads it, from the receiver. The texel blocks as it does in SingleLoop.hlsl.
const std::string kDecision =
    "QuadReceiver r; r.bounds.minimum = float2(0.0, 0.0); r.bounds.maximum = float2(1.0, 1.0); r.texelSize = "
    "1.0; r.centre = float2(0.0, 0.0); r.depth = In(2); r.gradient = In2(3); Out(0, DecideByRange(In2(0), r, "
    "In(5))); const float plane = KeepBehindNearPlane(r.depth + dot(r.gradient, In2(7))); Out(1, "
    "DepthGap(In(6), plane) > 0.0 && DepthGap(In(6), r.depth) > 0.0 ? 1.0 : 0.0);";

TEST(SingleLoopExits, WhatARangeDecidesHoldsForEveryTexelOfIt) {
  for (const DepthDirection direction : kDepthDirections) {
    const bool reversed = direction == DepthDirection::reversed;
    const std::vector<float> inputs = random_cases(
        75,
        [&](Random& random, int i) {
          // The range is narrow and close to the receiver's plane, where decisions are made, or any.
          const float depth = random.between(0.0f, 1.0f);
          const float reach = random.between(0.0f, 60.0f);
          const float slope = i % 4 == 0 ? 0.0f : std::fabs(random.magnitude(-6.0f, -2.0f));
          const float turn = random.between(0.0f, 6.2831853f);
          const float gradient_x = slope * std::cos(turn), gradient_y = slope * std::sin(turn);
          const float rise = slope * (reach + 0.75f);
          const float spread = i % 2 == 0 ? 1.0f : 3.0f * rise + 1e-6f;
          float a = std::clamp(depth + random.between(-spread, spread), 0.0f, 1.0f);
          float b = std::clamp(depth + random.between(-spread, spread), 0.0f, 1.0f);
          if (i % 5 == 0) a = depth;
          const float nearest = reversed ? std::max(a, b) : std::min(a, b);
          const float farthest = reversed ? std::min(a, b) : std::max(a, b);
          // The texel lies at one of the range's ends, uphill or downhill at the end of the reach, or
          // anywhere between.
          const float texel = i % 3 == 0   ? nearest
                              : i % 3 == 1 ? farthest
                                           : a + (b - a) * random.between(0.0f, 1.0f);
          const float far = reach + 0.7071f;
          const float along = i % 7 == 0 ? far : i % 7 == 1 ? -far : random.between(-far, far);
          return Case{nearest,
                      farthest,
                      depth,
                      gradient_x,
                      gradient_y,
                      reach,
                      std::clamp(texel, std::min(a, b), std::max(a, b)),
                      along * std::cos(turn),
                      along * std::sin(turn)};
        },
        kReceivers);
    CoreFunction function = function_in("Filters/SingleLoop", "SingleLoopRanges", kDecision, 9, 2);
    const std::vector<float> out = run(function, direction, inputs);
    int lit = 0, dark = 0, undecided = 0;
    for (std::size_t i = 0; i < out.size() / 2; ++i) {
      const float decided = out[2 * i], blocks = out[2 * i + 1];
      ASSERT_TRUE(decided != 1.0f || blocks == 0.0f) << i;
      ASSERT_TRUE(decided != 0.0f || blocks == 1.0f) << i;
      ++(decided == 1.0f ? lit : decided == 0.0f ? dark : undecided);
    }
    EXPECT_GT(lit, kReceivers / 20);
    EXPECT_GT(dark, kReceivers / 20);
    EXPECT_GT(undecided, kReceivers / 20);
  }
}

// The sixteen depths are those of a plane, of one with a thin layer of noise, of two surfaces, or of nothing
// but noise; receivers are near their plane, or anywhere. The block lies anywhere around the receiver.
const std::string kPlanes =
    "QuadReceiver r; r.bounds.minimum = float2(0.0, 0.0); r.bounds.maximum = float2(1.0, 1.0); r.texelSize = "
    "1.0; r.centre = float2(0.0, 0.0); r.depth = In(16); r.gradient = In2(17); const float2 away = In2(19); "
    "float4 depths[4]; int i; for (i = 0; i < 4; ++i) depths[i] = float4(In(4 * i), In(4 * i + 1), In(4 * i "
    "+ 2), In(4 * i + 3)); r.inPerspective = false; r.awayFromAxis = 0.0; const GroupBounds block = "
    "BoundBlock(PlanesOfBlock(depths), away, 4.0, 0.0, GroupOf(r)); Out(0, block.noneAbove ? 1.0 : "
    "block.allAbove && block.smallestGap > 0.0 ? 0.0 : -1.0); int blocking = 0; for (i = 0; i < 16; ++i) "
    "{const float2 at = away + QuarterCorner(i / 4) + float2(kGatherX[i % 4], kGatherY[i % 4]); const float "
    "plane = KeepBehindNearPlane(r.depth + dot(r.gradient, at)); if (DepthGap(depths[i / 4][i % 4], plane) > "
    "0.0 && DepthGap(depths[i / 4][i % 4], r.depth) > 0.0) ++blocking; }OutInt(1, blocking);";

TEST(SingleLoopExits, WhatPlanesDecideHoldsForEveryTexelOfTheirBlock) {
  for (const DepthDirection direction : kDepthDirections) {
    Random random(76);
    std::vector<float> inputs;
    for (int i = 0; i < kReceivers; ++i) {
      const float slope = i % 4 == 0 ? 0.0f : std::fabs(random.magnitude(-6.0f, -1.5f));
      const float x = slope * random.between(-1.0f, 1.0f), y = slope * random.between(-1.0f, 1.0f);
      const float level = random.between(-0.1f, 1.1f);
      const float noise = i % 5 == 0 ? 0.0f : i % 5 == 4 ? 1.0f : std::fabs(random.magnitude(-7.0f, -2.0f));
      const float step = i % 3 == 0 ? random.between(-0.5f, 0.5f) : 0.0f;
      const float away_x = random.between(-40.0f, 40.0f), away_y = random.between(-40.0f, 40.0f);
      for (int texel = 0; texel < 16; ++texel) {
        const float dx = static_cast<float>(texel % 4) - 1.5f, dy = static_cast<float>(texel / 4) - 1.5f;
        const float surface =
            level + x * dx + y * dy + (texel > 5 ? step : 0.0f) + random.between(-noise, noise);
        inputs.push_back(std::clamp(surface, 0.0f, 1.0f));
      }
      const float gap = i % 2 == 0 ? random.magnitude(-7.5f, -2.0f) : random.between(-1.0f, 1.0f);
      const float tilt = i % 7 == 0 ? random.between(0.0f, 2.0f) : 1.0f;
      inputs.insert(inputs.end(), {std::clamp(level - tilt * (x * away_x + y * away_y) + gap, 0.0f, 1.0f),
                                   tilt * x, tilt * y, away_x, away_y});
    }
    const std::vector<float> out =
        run({"ReceiverGroup", kPlanes, 21, 2, {}, "Filters/Decisions"}, direction, inputs);
    int lit = 0, dark = 0, undecided = 0;
    for (std::size_t i = 0; i < out.size() / 2; ++i) {
      const float decided = out[2 * i], blocking = out[2 * i + 1];
      ASSERT_LE(blocking, 16.0f) << i << ": a gap beyond the bounds";
      ASSERT_TRUE(decided != 1.0f || blocking == 0.0f) << i << ": " << blocking;
      ASSERT_TRUE(decided != 0.0f || blocking == 16.0f) << i << ": " << blocking;
      ++(decided == 1.0f ? lit : decided == 0.0f ? dark : undecided);
    }
    EXPECT_GT(lit, kReceivers / 20);
    EXPECT_GT(dark, kReceivers / 20);
    EXPECT_GT(undecided, kReceivers / 20);
  }
}

TEST(SingleLoopExits, FacingAwayIsDarkOnlyWhereTheFourTapsAre) {
  const std::vector<float> inputs{-0.5f, 0.0f, 0.0f, 0.0f, 0.1f, 0.0f, -0.5f, 0.25f, -1.0f, 1.0f, 1.0f, 1.0f};
  const std::vector<float> out = run({"SingleLoopRanges",
                                      "OutInt(0, IsDarkFacingAway(In(0), In(1)) ? 1 : 0);",
                                      2,
                                      1,
                                      {},
                                      "Filters/SingleLoop"},
                                     inputs);
  const std::vector<float> expected{1.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f};
  EXPECT_EQ(out, expected);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
