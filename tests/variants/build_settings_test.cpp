// Unity 6000.3's shader build settings change what a program declares.
#include "variants/build_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "input/input_error_matcher.h"
#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

std::string settings(const std::string& block) {
  return "%YAML 1.1\n--- !u!30 &1\nGraphicsSettings:\n  m_Fog: 1\n  m_ShaderBuildSettings:\n" + block +
         "  m_LightsUseLinearIntensity: 1\n  defines:\n  - NOT_THESE 1\n";
}

std::string overriding(const std::string& keywords, int mode) {
  std::string block = "    keywordDeclarationOverrides:\n    - keywords:\n";
  for (std::size_t at = 0; at < keywords.size(); at += 2)  // "A-B+": A is stripped, B is kept
    block += std::string("      - name: ") + keywords[at] +
             "\n        keepInBuild: " + (keywords[at + 1] == '+' ? "1" : "0") + "\n";
  return settings(block + "      variantGenerationMode: " + std::to_string(mode) + "\n");
}

BuildSettings read(const std::string& text) {
  BuildSettings all;
  parse_build_settings(text, "s", all);
  return all;
}

Pragmas changed(const std::string& program, const std::string& keywords, int mode) {
  Pragmas pragmas = pragmas_of(program);
  apply_overrides(read(overriding(keywords, mode)).overrides, pragmas);
  return pragmas;
}

TEST(BuildSettings, StripKeywords) {
  const std::string program = "#pragma multi_compile _ A B\n#pragma multi_compile _ A\n";
  EXPECT_THAT(labels_of(changed(program, "_+B-A+", 0)), ElementsAre("_ A", "_ A"));
  EXPECT_THAT(labels_of(changed(program, "_-B+A+", 0)), ElementsAre("A B", "_ A"));
  EXPECT_THAT(labels_of(changed(program, "_-B-A-", 0)), ElementsAre("_ A")) << "a set that is stripped whole";
  EXPECT_THAT(labels_of(changed(program, "B-A+", 0)), ElementsAre("_ A B", "_ A")) << "of another set";
}

TEST(BuildSettings, ChangeTheKindOfASet) {
  const std::string program = "#pragma multi_compile _ A\n#pragma shader_feature __ B\n";
  EXPECT_EQ(changed(program, "_+A+", 1).keyword_sets[0].kind, KeywordSet::Kind::shader_feature);
  EXPECT_EQ(changed(program, "_+B+", 2).keyword_sets[1].kind, KeywordSet::Kind::multi_compile);
  const Pragmas dynamic = changed(program, "_+A+", 3);
  EXPECT_THAT(labels_of(dynamic), ElementsAre("_ B"));
  ASSERT_EQ(dynamic.dynamic_keywords.size(), 1U);
  EXPECT_EQ(dynamic.dynamic_keywords[0].name, "A");
}

TEST(BuildSettings, DefineConstantsAndChooseCompilers) {
  const BuildSettings all = read(settings(
      "    keywordDeclarationOverrides: []\n    defines:\n    - QUALITY 2\n    - STEP  0.5h\n    "
      "numInternalDefines: 0\n    compilerSettings:\n    - graphicsAPI: 21\n      "
      "compilerToolchainOverride: 2\n    - graphicsAPI: 2\n      compilerToolchainOverride: 1\n    - "
      "graphicsAPI: 16\n      compilerToolchainOverride: 0\n"));
  EXPECT_THAT(all.overrides, IsEmpty());
  EXPECT_THAT(all.defines, ElementsAre(Pair("QUALITY", "2"), Pair("STEP", "0.5h")));
  EXPECT_THAT(all.dxc, ElementsAre(Pair(GraphicsApi::d3d11, false), Pair(GraphicsApi::vulkan, true)));
  EXPECT_THAT(read("GraphicsSettings:\n  m_Fog: 1\n").defines, IsEmpty());
}

TEST(BuildSettings, NameTheColourSpaceAndTheEncodingOfLightmaps) {
  const std::string player =
      "PlayerSettings:\n  m_ActiveColorSpace: 0\n  m_BuildTargetGroupLightmapEncodingQuality:\n  - "
      "m_BuildTarget: "
      "Standalone\n    m_EncodingQuality: 1\n  - m_BuildTarget: iPhone\n    m_EncodingQuality: 2\n";
  const auto names = [&](const std::string& text, bool mobile) {
    Platform platform;
    platform.mobile = mobile;
    apply_settings(read(text), platform);
    std::string found;
    for (const auto& [name, value] : pragma_defines(platform))
      if (name.starts_with("UNITY_LIGHTMAP_") || name == "UNITY_COLORSPACE_GAMMA") found += name + " ";
    return found;
  };
  EXPECT_EQ(names(player, false), "UNITY_COLORSPACE_GAMMA UNITY_LIGHTMAP_RGBM_ENCODING ");
  EXPECT_EQ(names(player, true), "UNITY_COLORSPACE_GAMMA UNITY_LIGHTMAP_FULL_HDR ");
  EXPECT_EQ(names("  m_ActiveColorSpace: 1\n", false), "UNITY_LIGHTMAP_FULL_HDR ");
  EXPECT_EQ(names("", true), "UNITY_LIGHTMAP_DLDR_ENCODING ");
}

TEST(BuildSettings, WrongValuesAreNamedWithTheirLine) {
  expect_input_error([] { read(settings("    defines:\n    - QUALITY\n")); }, HasSubstr("s:7"));
  expect_input_error([] { read(overriding("A+", 4)); }, HasSubstr("s:10"));
  expect_input_error([] { read(overriding("1+", 0)); }, HasSubstr("is not a keyword"));
  expect_input_error([] { read("  m_ActiveColorSpace: x\n"); }, HasSubstr("s:1"));
}

}  // namespace
}  // namespace penumbra::variants
