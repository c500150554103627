// PenumbraHdrpVisibility on maps whose answer is plain: a blocker over the whole tile, or nothing, with every
// keyword, either depth direction, and a neighbouring tile that says the opposite.
#include <gtest/gtest.h>

#include "ShaderLibrary/hdrp_frame.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr int kTileTexels = 64;

// Two tiles lie side by side. The light looks along +Z of the world from z = 0 and sees 20 m; stored depth
// 0.5 is z = 10, where the receivers stand.
HdrpFrame two_tiles(DepthDirection direction, float first_tile, float second_tile) {
  HdrpFrame frame;
  const float toward = direction == DepthDirection::reversed ? -1.0f : 1.0f;
  HdrpShadow shadow;
  shadow.view = {glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 1, 0)};
  shadow.projection = {0.1f, 0.1f, toward / 20.0f, toward > 0.0f ? 0.0f : 1.0f};
  shadow.tile_texels = glm::vec2(static_cast<float>(kTileTexels));
  frame.shadows = {shadow, shadow};
  frame.shadows[1].atlas_offset = {0.5f, 0.0f};
  frame.spheres = {glm::vec4(0.0f, 0.0f, 10.0f, 10000.0f), glm::vec4(0.0f)};
  frame.atlas_texels = glm::vec2(2.0f * kTileTexels, kTileTexels);
  for (int texel = 0; texel < 2 * kTileTexels * kTileTexels; ++texel) {
    frame.atlas.push_back(texel % (2 * kTileTexels) < kTileTexels ? first_tile : second_tile);
  }
  frame.forward = {0.0f, 0.0f, 1.0f};
  frame.main_light_params = {0.0f, 0.05f, 0.0f, 0.0f};
  frame.pcss = {glm::vec4(24.0f, 16.0f, 2.0f, 1.5f), glm::vec4(0.56f, 0.5f, 0.105f, 0.105f)};
  return frame;
}

// The places lead from the middle of the tile to its right edge, where the other tile begins.
const std::vector<float> kAcross{0.0f, 5.0f, 9.0f, 9.6f, 9.9f, 9.99f};

class HdrpVisibility : public ::testing::TestWithParam<std::string> {
 protected:
  std::vector<float> seen(DepthDirection direction, float first_tile, float second_tile,
                          float dimmer = 1.0f) const {
    const HdrpFunction function{
        "Out(0, PenumbraHdrpVisibility(float3(In(0), 0.0, 10.0), float3(0.0, 0.0, -1.0), float2(17.0, "
        "5.0)));",
        1,
        1,
        {{GetParam(), "1"}}};
    HdrpFrame frame = two_tiles(direction, first_tile, second_tile);
    frame.dimmer = dimmer;
    return run(function, HdrpVersion::v14, direction, frame, kAcross);
  }
};
INSTANTIATE_TEST_SUITE_P(EveryKeyword, HdrpVisibility,
                         ::testing::Values("_", "_PENUMBRA_HARD", "_PENUMBRA_BILINEAR", "_PENUMBRA_FOUR_TAP",
                                           "_PENUMBRA_TENT_3X3", "_PENUMBRA_TENT_7X7", "_PENUMBRA_PCSS",
                                           "_PENUMBRA_PCSS_POISSON", "_PENUMBRA_PCSS_HDRP"),
                         [](const auto& test) { return "Keyword" + test.param; });

TEST_P(HdrpVisibility, IsDarkUnderABlockerAndLitWithoutUpToTheTilesEdge) {
  for (const DepthDirection direction : kDepthDirections) {
    const float near_light = direction == DepthDirection::reversed ? 0.6f : 0.4f;  // 2 m above the receivers
    const float far_away = 1.0f - near_light;                                      // 2 m below them
    for (const float visibility : seen(direction, near_light, far_away)) EXPECT_EQ(visibility, 0.0f);
    for (const float visibility : seen(direction, far_away, near_light)) EXPECT_EQ(visibility, 1.0f);
  }
}

TEST_P(HdrpVisibility, TheLightsDimmerLeavesTheRestOfTheLight) {
  for (const float visibility : seen(DepthDirection::reversed, 0.6f, 0.4f, 0.25f))
    EXPECT_EQ(visibility, 0.75f);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
