#include "shaders/cross_compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "shader_files.h"
#include "shaders/compile.h"

namespace penumbra::shaders {
namespace {

using testing::HasSubstr;

std::vector<std::uint32_t> module_of(const std::string& text, hlsl::Stage stage) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = text;
  request.stage = stage;
  return compile(request).spirv;
}

constexpr const char* shadow_fragment = R"(
Texture2D<float> _ShadowMap;
SamplerComparisonState sampler_ShadowMap;
float _Bias;
float4 Main(float3 coord : TEXCOORD0) : SV_Target
{
    return _ShadowMap.SampleCmpLevelZero(sampler_ShadowMap, coord.xy, coord.z + _Bias);
}
)";

std::filesystem::path golden_file(Target target) {
  return std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests/shaders/golden" /
         (std::string("shadow_fragment.") + target_name(target));
}

std::string golden(Target target) {
  std::ifstream file(golden_file(target), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// The files were read once and found right: the test holds that the emission does not change unseen.
// PENUMBRA_UPDATE_GOLDEN=1 writes them anew, to be read again.
TEST(CrossCompile, ShadowFragmentIsTheGoldenTextInEveryTarget) {
  const std::vector<std::uint32_t> spirv = module_of(shadow_fragment, hlsl::Stage::fragment);
  for (const Target target : all_targets) {
    const CrossCompileResult result = cross_compile(spirv, target);
    EXPECT_TRUE(result.diagnostics.empty());
    if (std::getenv("PENUMBRA_UPDATE_GOLDEN") != nullptr) std::ofstream(golden_file(target)) << result.text;
    EXPECT_EQ(result.text, golden(target)) << target_name(target);
  }
}

TEST(CrossCompile, EveryStageReachesEveryTarget) {
  const std::pair<std::string, hlsl::Stage> shaders[] = {
      {"float4x4 _M; float4 Main(float3 p : POSITION) : SV_Position { return mul(_M, float4(p, 1)); }",
       hlsl::Stage::vertex},
      {shadow_fragment, hlsl::Stage::fragment},
      {compute_shader("_In[id.x].y", "StructuredBuffer<float4> _In;\n"), hlsl::Stage::compute}};
  for (const auto& [text, stage] : shaders) {
    for (const Target target : all_targets) {
      if (target == Target::essl300 && stage == hlsl::Stage::compute) continue;  // it has none
      const CrossCompileResult result = cross_compile(module_of(text, stage), target);
      EXPECT_FALSE(result.text.empty()) << target_name(target);
      EXPECT_TRUE(result.diagnostics.empty()) << target_name(target);
    }
  }
}

TEST(CrossCompile, SamplersAreCombinedByName) {
  const std::string text =
      cross_compile(
          module_of(compute_shader("_A.SampleLevel(sampler_P, float2(0, 0), 0) + _A.Load(int3(0, 0, 0))",
                                   "Texture2D<float> _A;\nSamplerState sampler_P;\n"),
                    hlsl::Stage::compute),
          Target::glsl450)
          .text;
  EXPECT_THAT(text, HasSubstr("uniform sampler2D _A_sampler_P;"));
  EXPECT_THAT(text, HasSubstr("uniform sampler2D _A;"));
}

TEST(CrossCompile, WhatATargetCannotSayIsADiagnosticThatNamesIt) {
  // Desktop GLSL and HLSL have double precision, ESSL 3.10 does not.
  const std::vector<std::uint32_t> spirv =
      module_of(compute_shader("float(_In[id.x] * _In[id.y])", "StructuredBuffer<double> _In;\n"),
                hlsl::Stage::compute);
  ASSERT_FALSE(spirv.empty());
  EXPECT_TRUE(cross_compile(spirv, Target::glsl450).diagnostics.empty());
  const CrossCompileResult result = cross_compile(spirv, Target::essl310);
  EXPECT_TRUE(result.text.empty());
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics.front().file, "essl310");
  EXPECT_THAT(result.diagnostics.front().message, HasSubstr("FP64"));
}

TEST(CrossCompile, AMissingFeatureIsNamed) {
  const auto message = [](const std::string& text, hlsl::Stage stage, Target target) {
    const CrossCompileResult result = cross_compile(module_of(text, stage), target);
    return result.diagnostics.empty() ? std::string("none") : result.diagnostics.front().message;
  };
  const std::string compute = compute_shader("_In[id.x].y", "StructuredBuffer<float4> _In;\n");
  EXPECT_THAT(message(compute, hlsl::Stage::compute, Target::essl300), HasSubstr("ESSL 3.10"));
  EXPECT_EQ(message(compute, hlsl::Stage::compute, Target::essl310), "none");
  const std::string derivative = "float4 Main(float2 u : TEXCOORD0) : SV_Target { return ddx_fine(u.xyxy); }";
  EXPECT_THAT(message(derivative, hlsl::Stage::fragment, Target::essl310), HasSubstr("derivative"));
  EXPECT_EQ(message(derivative, hlsl::Stage::fragment, Target::glsl450), "none");
}

TEST(CrossCompile, BrokenModuleIsADiagnostic) {
  const CrossCompileResult result = cross_compile({1, 2, 3, 4, 5, 6}, Target::msl23);
  EXPECT_TRUE(result.text.empty());
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics.front().file, "msl23");
}

// HLSL's b registers end at b13 and its samplers at s15, however many resources of other kinds there are.
TEST(CrossCompile, RegistersCountFromZeroPerKind) {
  std::string before;
  std::string sum = "0";
  for (int i = 0; i < 16; ++i) {
    before += "StructuredBuffer<float> _B" + std::to_string(i) + ";\n";
    sum += " + _B" + std::to_string(i) + "[id.x]";
  }
  before += "Texture2D<float> _T;\nSamplerState sampler_T;\nfloat _Scale;\n";
  const std::string text =
      cross_compile(
          module_of(compute_shader(sum + " + _T.SampleLevel(sampler_T, float2(0, 0), 0) * _Scale", before),
                    hlsl::Stage::compute),
          Target::hlsl50)
          .text;
  EXPECT_THAT(text, HasSubstr("register(b0)"));
  EXPECT_THAT(text, HasSubstr("register(s0)"));
  EXPECT_THAT(text, HasSubstr("register(t17)"));
}

// The gathers stand among reads of one texel, whose text is the same but for the name.
TEST(CrossCompile, HlslGathersComparisons) {
  const std::string text =
      "Texture2D<float> T; TextureCube<float> C; SamplerComparisonState S;\n"
      "float4 Main(float3 u : TEXCOORD0) : SV_Target { return T.GatherCmp(S, u.xy, u.z)\n"
      "  + T.GatherCmp(S, u.xy, 0.5, int2(-3, 2)) + T.SampleCmpLevelZero(S, u.xy, 0.5, int2(1, 0))\n"
      "  + C.GatherCmp(S, u, 0.25); }";
  const CrossCompileResult result = cross_compile(module_of(text, hlsl::Stage::fragment), Target::hlsl50);
  ASSERT_TRUE(result.diagnostics.empty()) << format(result.diagnostics.front());
  EXPECT_THAT(result.text, HasSubstr("0.5f, int2(-3, 2))"));
  EXPECT_THAT(result.text, HasSubstr("C.GatherCmp(S, u, 0.25f)"));
  EXPECT_THAT(result.text, HasSubstr("T.SampleCmpLevelZero("));
  EXPECT_THAT(result.text, HasSubstr("0.5f, int2(1, 0))"));
  CompileRequest again;
  again.file = "again.hlsl";
  again.text = result.text;
  again.entry = "main";
  again.stage = hlsl::Stage::fragment;
  EXPECT_FALSE(compile(again).spirv.empty()) << result.text;
}

TEST(CrossCompile, NamesAndTargetsAreOneToOne) {
  for (const Target target : all_targets) EXPECT_EQ(find_target(target_name(target)), target);
  EXPECT_EQ(find_target("essl320"), std::nullopt);
}

}  // namespace
}  // namespace penumbra::shaders
