#include "validation/platform_targets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace penumbra::validation {
namespace {

using testing::ElementsAre;
using variants::GraphicsApi;

std::vector<GraphicsApi> apis(const std::vector<PlatformTargets>& platforms) {
  std::vector<GraphicsApi> apis;
  for (const PlatformTargets& each : platforms) apis.push_back(each.platform.api);
  return apis;
}

TEST(PlatformTargets, EachIsForTheApiWhoseShadersItIs) {
  const auto platforms = platform_targets({"spirv", "essl310", "glsl450", "msl23", "hlsl50", "essl300"}, {});
  EXPECT_THAT(apis(platforms),
              testing::UnorderedElementsAre(GraphicsApi::vulkan, GraphicsApi::gles3, GraphicsApi::glcore,
                                            GraphicsApi::metal, GraphicsApi::d3d11));
  for (const PlatformTargets& each : platforms) {
    EXPECT_EQ(each.platform.mobile, each.platform.api == GraphicsApi::gles3);
    if (each.platform.api == GraphicsApi::gles3) {
      EXPECT_THAT(each.targets, ElementsAre("essl310", "essl300"));
    }
  }
}

TEST(PlatformTargets, OneApiForAllIsAskedFor) {
  const auto platforms = platform_targets(
      {"spirv", "essl310"}, {.api = GraphicsApi::metal, .mobile = true, .unity_version = 60000});
  ASSERT_THAT(apis(platforms), ElementsAre(GraphicsApi::metal));
  EXPECT_THAT(platforms.front().targets, ElementsAre("spirv", "essl310"));
  EXPECT_TRUE(platforms.front().platform.mobile);
  EXPECT_EQ(platforms.front().platform.unity_version, 60000);
}

TEST(PlatformTargets, VersionsOfVulkanAreCompiledApart) {
  const auto platforms = platform_targets({"vulkan1.2", "spirv", "vulkan1.0"}, {});
  ASSERT_THAT(apis(platforms), ElementsAre(GraphicsApi::vulkan, GraphicsApi::vulkan, GraphicsApi::vulkan));
  EXPECT_EQ(platforms[0].vulkan, shaders::VulkanVersion::v1_0);
  EXPECT_THAT(platforms[1].targets, ElementsAre("spirv"));
  EXPECT_EQ(platforms[2].vulkan, shaders::VulkanVersion::v1_2);
}

}  // namespace
}  // namespace penumbra::validation
