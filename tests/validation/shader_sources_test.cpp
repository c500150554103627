// Tests the programs and variants of a shader's own text and of what it includes.
#include "validation/shader_sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "shaders/shader_files.h"

namespace penumbra::validation {
namespace {

TEST(ShaderSources, IncludedPragmasAreFoundBesideTheShader) {
  const shaders::ShaderFiles files;
  files.write("package.json", "");
  files.write("shared/Both.hlsl", "#include_with_pragmas \"Keywords.hlsl\"\n");
  files.write("own/Keywords.hlsl", "#pragma multi_compile _ WIDE\n");
  files.write("own/K.compute", "#pragma kernel K\n#include_with_pragmas \"../shared/Both.hlsl\"\n");
  SourceOptions options;
  options.platforms = {{{}, {"spirv"}}};
  ShaderSources sources(options);
  sources.add({files.path("own/K.compute"), "K.compute"});
  EXPECT_EQ(sources.units().size(), 2U);
}

const std::string kWater =
    "Shader \"My/Water\" { SubShader { Pass { Name \"Forward\"\nHLSLPROGRAM\n#pragma vertex V\n#pragma "
    "fragment "
    "F\n#pragma shader_feature _ A B\n#pragma multi_compile _ FOG\nENDHLSL\n} Pass { Name \"Depth\"\n"
    "HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n#pragma multi_compile _ FOG\nENDHLSL\n} } }\n";

ShaderSources water(const shaders::ShaderFiles& files, SourceOptions options) {
  files.write("Water.shader", kWater);
  files.write("Water.shader.meta", "fileFormatVersion: 2\nguid: 0123456789abcdef0123456789abcdef\n");
  options.platforms = {{{}, {"spirv"}}};
  ShaderSources sources(std::move(options));
  sources.add({files.path("Water.shader"), "Water.shader"});
  return sources;
}

// The shader_feature sets keep what the material has, for each of two stages and FOG; Depth has no such set.
TEST(ShaderSources, MaterialsNarrowTheShaderOfTheirGuid) {
  const shaders::ShaderFiles files;
  SourceOptions options;
  options.used.emplace();
  options.used->add(
      "  m_Shader: {fileID: 4800000, guid: 0123456789abcdef0123456789abcdef, type: 3}\n"
      "  m_ValidKeywords:\n  - B\n",
      "Water.mat");
  const ShaderSources sources = water(files, std::move(options));
  ASSERT_EQ(sources.units().size(), 8U);
  EXPECT_EQ(sources.units().front().keywords, variants::Keywords{"B"});
  EXPECT_TRUE(sources.records().empty());
}

TEST(ShaderSources, APassThatTheLogLacksIsUnchecked) {
  const shaders::ShaderFiles files;
  SourceOptions options;
  options.used.emplace();
  options.used->add("Compiled shader: My/Water, pass: Forward, stage: vertex, keywords A FOG\n",
                    "Player.log");
  const ShaderSources sources = water(files, std::move(options));
  EXPECT_EQ(sources.units().size(), 2U);
  ASSERT_EQ(sources.records().size(), 1U);
  EXPECT_EQ(sources.records().front().pass, "Depth");
  EXPECT_EQ(sources.records().front().status, VariantStatus::unchecked);
}

TEST(ShaderSources, BuildSettingsOfTheProjectApply) {
  const shaders::ShaderFiles files;
  SourceOptions options;
  options.build_settings.defines = {{"QUALITY", "2"}};
  options.build_settings.dxc = {{variants::Platform().api, true}};
  options.build_settings.overrides = {{variants::KeywordOverride::Mode::as_declared, {"_", "FOG"}, {"FOG"}}};
  const std::vector<CompileUnit> units = water(files, std::move(options)).units();
  ASSERT_EQ(units.size(), 8U) << "three variants and one, of two stages";
  EXPECT_TRUE(units.front().compile.dxc);
  const auto& defines = units.front().compile.defines;
  EXPECT_NE(std::find(defines.begin(), defines.end(), std::pair<std::string, std::string>("QUALITY", "2")),
            defines.end());
}

}  // namespace
}  // namespace penumbra::validation
