#include "variants/platform_defines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace penumbra::variants {
namespace {

using hlsl::Stage;
using testing::Key;
using testing::Pair;
using testing::UnorderedElementsAre;

// Without the settings of a platform, which are nearly the same on all of its graphics APIs.
std::map<std::string, std::string> without_settings(std::map<std::string, std::string> defines) {
  const GraphicsApi api = defines.contains("SHADER_API_D3D11") ? GraphicsApi::d3d11 : GraphicsApi::glcore;
  const Platform plain{api, defines.contains("SHADER_API_MOBILE"), std::stoi(defines.at("UNITY_VERSION")),
                       false};
  for (const auto& [name, value] : pragma_defines(plain))
    if (!name.starts_with("SHADER_API_") && name != "UNITY_VERSION") {
      EXPECT_EQ(defines.erase(name), 1U) << name;
    }
  return defines;
}

TEST(PlatformDefines, AreThoseOfTheTable) {
  EXPECT_THAT(
      without_settings(platform_defines({GraphicsApi::vulkan, false, 202230, false}, Stage::fragment, 45)),
      UnorderedElementsAre(Pair("SHADER_API_VULKAN", "1"), Pair("SHADER_API_DESKTOP", "1"),
                           Pair("SHADER_STAGE_FRAGMENT", "1"), Pair("SHADER_TARGET", "45"),
                           Pair("UNITY_VERSION", "202230"), Pair("UNITY_COMPILER_HLSL", "1"),
                           Pair("UNITY_COMPILER_HLSLCC", "1")));
  EXPECT_THAT(
      without_settings(platform_defines({GraphicsApi::d3d11, false, 60000023, false}, Stage::compute, 50)),
      UnorderedElementsAre(Pair("SHADER_API_D3D11", "1"), Pair("SHADER_API_DESKTOP", "1"),
                           Pair("SHADER_STAGE_COMPUTE", "1"), Pair("SHADER_TARGET", "50"),
                           Pair("UNITY_VERSION", "60000023"), Pair("UNITY_COMPILER_HLSL", "1")));
  EXPECT_THAT(without_settings(platform_defines({GraphicsApi::gles3, true, 202230, true}, Stage::vertex, 35)),
              UnorderedElementsAre(Key("SHADER_API_GLES3"), Key("SHADER_API_MOBILE"),
                                   Key("SHADER_STAGE_VERTEX"), Key("SHADER_TARGET"), Key("UNITY_VERSION"),
                                   Key("SHADER_TARGET_GLSL"), Pair("_Object2World", "unity_ObjectToWorld"),
                                   Key("_World2Object"), Pair("_LightMatrix0", "unity_WorldToLight"),
                                   Key("unity_World2Shadow"), Key("_Projector"), Key("_ProjectorClip")));
}

// The lists are those of Unity's own error messages, "Platform defines:".
TEST(PlatformDefines, HaveTheSettingsOfDesktopsAndOfMobileDevices) {
  EXPECT_THAT(
      pragma_defines({GraphicsApi::d3d11, false, 60000023, false}),
      UnorderedElementsAre(Key("SHADER_API_D3D11"), Key("UNITY_VERSION"), Key("SHADER_API_DESKTOP"),
                           Key("UNITY_ENABLE_DETAIL_NORMALMAP"), Key("UNITY_ENABLE_REFLECTION_BUFFERS"),
                           Key("UNITY_LIGHTMAP_FULL_HDR"), Key("UNITY_LIGHT_PROBE_PROXY_VOLUME"),
                           Key("UNITY_PBS_USE_BRDF1"), Key("UNITY_PLATFORM_SUPPORTS_DEPTH_FETCH"),
                           Key("UNITY_SPECCUBE_BLENDING"), Key("UNITY_SPECCUBE_BOX_PROJECTION"),
                           Key("UNITY_USE_DITHER_MASK_FOR_ALPHABLENDED_SHADOWS")));
  EXPECT_THAT(
      pragma_defines({GraphicsApi::gles3, true, 202230, false}),
      UnorderedElementsAre(Key("SHADER_API_GLES3"), Key("UNITY_VERSION"), Key("SHADER_API_MOBILE"),
                           Key("UNITY_ENABLE_REFLECTION_BUFFERS"), Key("UNITY_LIGHTMAP_DLDR_ENCODING"),
                           Key("UNITY_NO_DXT5nm"), Key("UNITY_NO_RGBM"), Key("UNITY_NO_SCREENSPACE_SHADOWS"),
                           Key("UNITY_PBS_USE_BRDF2")));
}

// Returns every name that any program of a Unity version may have.
std::set<std::string> names_of(const std::string& version) {
  std::set<std::string> names;
  for (const GraphicsApi api : all_graphics_apis)
    for (int choice = 0; choice < 12; ++choice)
      for (const char* mode : {"ForwardBase", "ForwardAdd", "Deferred", "PrepassBase", "PrepassFinal",
                               "ShadowCaster", "Meta", "MotionVectors"})
        for (const Stage stage : hlsl::all_stages) {
          Platform platform{api, choice % 2 == 1, unity_version_number(version).value(), choice % 4 > 1};
          platform.light_mode = mode;
          platform.gamma = true;
          platform.lightmaps = static_cast<LightmapEncoding>(choice / 4);
          for (const auto& [name, value] : platform_defines(platform, stage, 45)) names.insert(name);
        }
  return names;
}

// Returns the names in the first cell of a row, between backticks.
std::vector<std::string> names_in_cell(std::string_view cell) {
  std::vector<std::string> names;
  while (cell.find('`') != std::string_view::npos) {
    cell.remove_prefix(cell.find('`') + 1);
    names.emplace_back(cell.substr(0, cell.find('`')));
    cell.remove_prefix(std::min(cell.find('`') + 1, cell.size()));
  }
  return names;
}

// The table of docs/validating.md for a Unity version.
std::set<std::string> names_on_the_page(bool is_6_0, bool is_6_3) {
  std::ifstream page(std::string(PENUMBRA_SOURCE_DIR) + "/docs/validating.md");
  std::set<std::string> names;
  bool in_table = false;
  for (std::string line; std::getline(page, line);) {
    if (line == "| names | value | where | Unity | source |") in_table = true;
    if (!in_table || !line.starts_with("| `")) continue;
    const std::string first = line.substr(0, line.find(" | "));
    const bool holds = line.find("| all |") != std::string::npos ||
                       (line.find("| before 6.0 |") != std::string::npos && !is_6_0) ||
                       (line.find("| from 6.0 |") != std::string::npos && is_6_0) ||
                       (line.find("| from 6.3 |") != std::string::npos && is_6_3);
    for (const std::string& name : names_in_cell(first))
      if (holds) names.insert(name);
    if (line.find("`_Object2World`") != std::string::npos) break;
  }
  return names;
}

TEST(PlatformDefines, AreThoseOfTheTableOnThePage) {
  for (const char* version : {"2021.3.1f1", "2022.3.62f1"})
    EXPECT_EQ(names_of(version), names_on_the_page(false, false)) << version;
  for (const char* version : {"6000.0.23f1", "6000.1.0f1", "6000.2.3f1"})
    EXPECT_EQ(names_of(version), names_on_the_page(true, false)) << version;
  for (const char* version : {"6000.3.0f1", "6000.4.1f1", "6000.5.0b1", "6000.6.0a1"})
    EXPECT_EQ(names_of(version), names_on_the_page(true, true)) << version;
}

TEST(PlatformDefines, NameThePassOfALightMode) {
  Platform platform{GraphicsApi::vulkan, false, 202230, false};
  platform.light_mode = "ShadowCaster";
  EXPECT_EQ(pragma_defines(platform).count("UNITY_PASS_SHADOWCASTER"), 1U);
  platform.light_mode = "UniversalForward";
  for (const auto& [name, value] : pragma_defines(platform))
    EXPECT_FALSE(name.starts_with("UNITY_PASS_")) << name;
}

TEST(PlatformDefines, LeaveToTheLibrariesWhatTheyDefine) {
  for (const GraphicsApi api : all_graphics_apis) {
    for (const auto& [name, value] : platform_defines({api, false, 202230, false}, Stage::vertex, 45)) {
      for (const char* theirs : {"UNITY_REVERSED_Z", "UNITY_UV_STARTS_AT_TOP", "UNITY_NEAR_CLIP_VALUE",
                                 "CBUFFER_START", "TEXTURE2D", "UNITY_INSTANCING_ENABLED"}) {
        EXPECT_NE(name, theirs) << renderer_name(api);
      }
    }
  }
}

TEST(PlatformDefines, OfAConditionAroundPragmasHaveNoStage) {
  EXPECT_THAT(without_settings(pragma_defines({GraphicsApi::nintendo_switch, false, 202230, false})),
              UnorderedElementsAre(Pair("SHADER_API_SWITCH", "1"), Pair("UNITY_VERSION", "202230")));
  EXPECT_THAT(without_settings(pragma_defines({GraphicsApi::metal, true, 202230, false})),
              UnorderedElementsAre(Key("SHADER_API_METAL"), Key("SHADER_API_MOBILE"), Key("UNITY_VERSION")));
}

// The Unity Manual, "Branch based on Unity version", has the first three.
TEST(PlatformDefines, VersionsBecomeNumbers) {
  EXPECT_EQ(unity_version_number("2022.3.0f1"), 202230);
  EXPECT_EQ(unity_version_number("2022.3"), 202230);
  EXPECT_EQ(unity_version_number("6000.0"), 60000000);
  EXPECT_EQ(unity_version_number("6000.0.2"), 60000002);
  EXPECT_EQ(unity_version_number("6000.2.3f1"), 60020003);
  EXPECT_EQ(unity_version_number("2022.3.21f1"), 202239);
  EXPECT_EQ(unity_version_number("6000.0.23f1"), 60000023);
  for (const char* wrong : {"", "2022", "x.1.2", "2022.3.", "-1.0.0", "99999999999.0.0", "5.0.1"}) {
    EXPECT_EQ(unity_version_number(wrong), std::nullopt) << wrong;
  }
}

TEST(PlatformDefines, ApisAreFoundByTheirRenderersName) {
  for (const GraphicsApi api : all_graphics_apis) EXPECT_EQ(find_graphics_api(renderer_name(api)), api);
  EXPECT_EQ(find_graphics_api("psp2"), std::nullopt);
}

}  // namespace
}  // namespace penumbra::variants
