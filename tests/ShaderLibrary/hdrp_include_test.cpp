// Pipelines/Hdrp.hlsl compiles by its one include: every keyword, both depth directions, every declared HDRP
// version, every target; after HDRP's shadow context too. The shader of Documentation~/pipelines.md compiles
// as it stands there.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "ShaderLibrary/hdrp_frame.h"
#include "shaders/compile.h"
#include "shaders/cross_compile.h"
#include "shaders/reflect.h"

namespace penumbra::shader_library_tests {
namespace {

const std::string kLit =
    "#include \"Packages/com.penumbra.shadows/ShaderLibrary/Pipelines/Hdrp.hlsl\"\n"
    "float4 Main(float4 pixel : SV_Position, float3 positionRWS : TEXCOORD0, float3 normalWS : TEXCOORD1) : "
    "SV_Target\n"
    "{ return PenumbraHdrpVisibility(positionRWS, normalWS, pixel.xy); }\n";

shaders::CompileResult compile(const std::string& text, const HdrpDefines& defines,
                               hlsl::Stage stage = hlsl::Stage::fragment, const std::string& entry = "Main") {
  shaders::CompileRequest request;
  request.file = "lit.hlsl";
  request.text = text;
  request.entry = entry;
  request.stage = stage;
  request.defines = defines;
  request.package_roots = hdrp_package_roots();
  shaders::CompileResult result = shaders::compile(request);
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) ADD_FAILURE() << hlsl::format(diagnostic);
  return result;
}

bool binds(const shaders::CompileResult& result, const std::string& name) {
  for (const shaders::Resource& resource : shaders::reflect(result.spirv).resources) {
    if (resource.name == name) return true;
  }
  return false;
}

HdrpDefines with(HdrpDefines defines, const std::string& name) {
  defines.emplace_back(name, "1");
  return defines;
}

class HdrpInclude : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(EveryKeyword, HdrpInclude,
                         ::testing::Values("_", "_PENUMBRA_HARD", "_PENUMBRA_BILINEAR", "_PENUMBRA_FOUR_TAP",
                                           "_PENUMBRA_TENT_3X3", "_PENUMBRA_TENT_7X7", "_PENUMBRA_PCSS",
                                           "_PENUMBRA_PCSS_POISSON", "_PENUMBRA_PCSS_HDRP"),
                         [](const auto& test) { return "Keyword" + test.param; });

TEST_P(HdrpInclude, CompilesForEveryVersionDirectionAndTarget) {
  for (const HdrpVersion version : kHdrpVersions) {
    const HdrpDefines defines = with(defines_of(version), GetParam());
    for (const HdrpDefines& all : {defines, with(defines, "UNITY_REVERSED_Z")}) {
      const shaders::CompileResult result = compile(kLit, all);
      ASSERT_FALSE(result.spirv.empty());
      EXPECT_TRUE(binds(result, "_ShadowmapCascadeAtlas"));
      EXPECT_EQ(binds(result, "sampler_PenumbraPointClamp"), GetParam().starts_with("_PENUMBRA_PCSS"));
      shaders::CrossCompiler module(result.spirv);
      for (const shaders::Target target : shaders::all_targets) {
        // HDRP needs compute shaders, and these targets have no structured buffers.
        if (target == shaders::Target::essl300 || target == shaders::Target::glsl410) continue;
        const shaders::CrossCompileResult text = module.to(target);
        for (const hlsl::Diagnostic& diagnostic : text.diagnostics) {
          EXPECT_NE(diagnostic.severity, hlsl::Severity::error) << hlsl::format(diagnostic);
        }
        EXPECT_FALSE(text.text.empty()) << shaders::target_name(target);
      }
    }
  }
}

// HDRP's own shadow context declares the atlas and the buffers; after it, the binding does not.
TEST(HdrpInclude, ComesAfterHdrpsShadowContext) {
  const std::string context =
      "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl\"\n"
      "#include \"Packages/com.unity.render-pipelines.high-definition/Runtime/ShaderLibrary/"
      "ShaderVariables.hlsl\"\n"
      "#include \"Packages/com.unity.render-pipelines.high-definition/Runtime/Lighting/Shadow/"
      "HDShadowManager.cs.hlsl\"\n"
      "#define HD_SHADOW_CONTEXT_HLSL\n"
      "TEXTURE2D(_ShadowmapCascadeAtlas);\n"
      "StructuredBuffer<HDShadowData> _HDShadowDatas;\n"
      "StructuredBuffer<HDDirectionalShadowData> _HDDirectionalShadowData;\n";
  EXPECT_FALSE(compile(context + kLit, {}).spirv.empty());
}

// The version decides unless the project does; then HDRP's packed settings are not read.
TEST(HdrpInclude, LeavesHdrpsSettingsWhereTheProjectSaysSo) {
  HdrpDefines defines = with(defines_of(HdrpVersion::v17), "_PENUMBRA_PCSS_HDRP");
  const std::vector<std::uint32_t> packed = compile(kLit, defines).spirv;
  defines.emplace_back("PENUMBRA_HDRP_PACKED_PCSS", "0");
  const std::vector<std::uint32_t> own = compile(kLit, defines).spirv;
  EXPECT_LT(own.size(), packed.size());
}

std::string between(const std::string& text, const std::string& first, const std::string& last) {
  const std::size_t begin = text.find(first);
  const std::size_t end = text.find(last, begin);
  if (begin == std::string::npos || end == std::string::npos) return {};
  return text.substr(begin + first.size(), end - begin - first.size());
}

TEST(HdrpDocumentation, ItsShaderCompiles) {
  std::ifstream file(PENUMBRA_SOURCE_DIR "/Documentation~/pipelines.md", std::ios::binary);
  const std::string page((std::istreambuf_iterator<char>(file)), {});
  const std::string shader = between(page.substr(page.find("\n## In HDRP\n")), "```hlsl\n", "```");
  const std::string program = between(shader, "HLSLPROGRAM", "ENDHLSL");
  ASSERT_NE(program.find("#pragma fragment Frag"), std::string::npos);
  for (const HdrpVersion version : kHdrpVersions) {
    for (const char* keyword : {"_", "_PENUMBRA_TENT_7X7", "_PENUMBRA_PCSS", "_PENUMBRA_PCSS_HDRP"}) {
      EXPECT_NE(program.find(keyword), std::string::npos) << keyword << " is none of the page's";
      const HdrpDefines defines = with(with(defines_of(version), keyword), "SHADER_API_D3D11");
      EXPECT_FALSE(compile(program, defines, hlsl::Stage::vertex, "Vert").spirv.empty());
      const shaders::CompileResult fragment = compile(program, defines, hlsl::Stage::fragment, "Frag");
      ASSERT_FALSE(fragment.spirv.empty());
      EXPECT_TRUE(binds(fragment, "_ShadowmapCascadeAtlas"));
    }
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
