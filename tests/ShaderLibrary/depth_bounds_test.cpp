// Map/DepthBounds.hlsl: the planes that eight bytes keep of a block still hold each of its texels, and lie
// hardly farther apart than those that were packed.
#include <gtest/gtest.h>

#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr int kTexels = 16;
constexpr int kPlanes = 8;  // gradient, nearest and farthest of the packed planes, then of those before

// Sixteen depths row by row: of a slope, of a slope with a step, anywhere, all equal, at the ends of the
// range.
std::vector<float> blocks_of_texels() {
  Random random(91);
  std::vector<float> depths;
  for (int i = 0; i < kRandomCases; ++i) {
    const float steepness = std::exp2(random.between(-20.0f, -3.0f));
    const float across = steepness * random.between(-1.0f, 1.0f);
    const float down = steepness * random.between(-1.0f, 1.0f);
    const float middle = random.between(0.0f, 1.0f);
    const float step = i % 5 == 1 ? random.between(-0.5f, 0.5f) : 0.0f;
    for (int texel = 0; texel < kTexels; ++texel) {
      const float x = static_cast<float>(texel % 4) - 1.5f, y = static_cast<float>(texel / 4) - 1.5f;
      float depth = middle + across * x + down * y + (x + y > 0.5f ? step : 0.0f);
      if (i % 5 == 2) depth = random.between(0.0f, 1.0f);
      if (i % 5 == 3) depth = middle;
      if (i % 5 == 4) depth = random.between(0.0f, 1.0f) < 0.5f ? 0.0f : 1.0f;
      depths.push_back(std::fmin(std::fmax(depth, 0.0f), 1.0f));
    }
  }
  return depths;
}

// Packs the planes of the block, or of a block whose four parts are all like it.
std::vector<float> packed_planes(const std::vector<float>& depths, DepthDirection direction, bool joined) {
  const std::string planes =
      "float4 q[4]; for (int i = 0; i < 4; ++i) { const int first = 2 * (i & 1) + 8 * (i >> 1); q[i] = "
      "float4(In(first + 4), In(first + 5), In(first + 1), In(first)); } DepthPlanes p = PlanesOfBlock(q);";
  const std::string join =
      "DepthPlanes parts[4]; for (int j = 0; j < 4; ++j) parts[j] = p; p = JoinPlanes(parts, 4.0); ";
  const std::string out =
      "Out2(0, k.gradient.xy); Out(2, k.nearest); Out(3, k.farthest); Out2(4, p.gradient.xy); Out(6, "
      "p.nearest); Out(7, p.farthest);";
  return run(function_in("Map", "DepthBounds",
                         planes + (joined ? join : "") + "const DepthPlanes k = UnpackBounds(PackBounds(p, " +
                             (joined ? "8.0" : "4.0") + ")); " + out,
                         kTexels, kPlanes),
             direction, depths);
}

TEST(DepthBounds, HoldEveryTexelAndLieHardlyFartherApart) {
  const std::vector<float> depths = blocks_of_texels();
  for (const DepthDirection direction : kDepthDirections) {
    const double towards = direction == DepthDirection::reversed ? 1.0 : -1.0;
    for (const bool joined : {false, true}) {
      const std::vector<float> out = packed_planes(depths, direction, joined);
      int known = 0;
      for (std::size_t i = 0; i < depths.size() / kTexels; ++i) {
        const float* plane = &out[kPlanes * i];
        const double thickness = towards * (double(plane[2]) - double(plane[3]));
        const double before = towards * (double(plane[6]) - double(plane[7]));
        // The parts of a joined block lie two texels from its middle, along both axes.
        for (int part = 0; part < (joined ? 4 : 1); ++part)
          for (int texel = 0; texel < kTexels; ++texel) {
            const double x = texel % 4 - 1.5 + (joined ? 4 * (part % 2) - 2 : 0);
            const double y = texel / 4 - 1.5 + (joined ? 4 * (part / 2) - 2 : 0);
            const double depth = depths[kTexels * i + static_cast<std::size_t>(texel)];
            const double rise = double(plane[0]) * x + double(plane[1]) * y;
            const double terms = 1.0 + std::abs(rise) + std::abs(plane[2]) + std::abs(plane[3]);
            ASSERT_GE(towards * (double(plane[2]) + rise - depth), -4e-6 * terms) << i << " texel " << texel;
            ASSERT_GE(towards * (depth - double(plane[3]) - rise), -4e-6 * terms) << i << " texel " << texel;
          }
        if (thickness > 1.99) continue;
        ++known;
        const double turned = (std::abs(plane[0] - plane[4]) + std::abs(plane[1] - plane[5])) * 8.0;
        ASSERT_LE(thickness, before * (1.0 + 1.0 / 64.0) + 2.0 * turned + 1.2e-5) << i;
      }
      EXPECT_GT(known, kRandomCases * 4 / 5);
    }
  }
}

// Planes that leave the range of the packed numbers become those between which every map lies. Gaps are
// before the far end.
TEST(DepthBounds, OfPlanesOutOfRangeHoldEveryMap) {
  constexpr float kGaps[][2] = {{3.0f, 0.5f}, {1.6f, 1.5f}, {0.9f, -1.2f}, {-0.6f, -0.7f}, {1.0f, -2.0f}};
  for (const DepthDirection direction : kDepthDirections) {
    const bool reversed = direction == DepthDirection::reversed;
    std::vector<float> planes;
    for (const auto& gaps : kGaps)
      for (const float gap : gaps) planes.push_back(reversed ? gap : 1.0f - gap);
    const std::vector<float> out =
        run(function_in(
                "Map", "DepthBounds",
                "DepthPlanes p; p.gradient = float2(0.0, 0.0); p.nearest = In(0); p.farthest = In(1); const "
                "DepthPlanes k = UnpackBounds(PackBounds(p, 4.0)); Out(0, k.nearest); Out(1, k.farthest);",
                2, 2),
            direction, planes);
    for (std::size_t i = 0; i < planes.size(); i += 2) {
      EXPECT_LE(std::fmin(out[i], out[i + 1]), 0.0f) << i / 2;
      EXPECT_GE(std::fmax(out[i], out[i + 1]), 1.0f) << i / 2;
    }
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
