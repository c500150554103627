// Tests what compile() takes and delivers, bad files included.
#include "shaders/compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "shader_files.h"
#include "spirv/code.h"

namespace penumbra::shaders {
namespace {

using testing::AllOf;
using testing::HasSubstr;

CompileResult compile_text(const std::string& text, hlsl::Stage stage = hlsl::Stage::compute,
                           bool optimise = true) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = text;
  request.stage = stage;
  request.optimise = optimise;
  return compile(request);
}

std::string first_message(const CompileResult& result) {
  return result.diagnostics.empty() ? "" : format(result.diagnostics.front());
}

TEST(Compile, VertexFragmentAndComputeStages) {
  EXPECT_FALSE(compile_text("float4 Main(float3 p : POSITION) : SV_Position { return float4(p, 1); }",
                            hlsl::Stage::vertex)
                   .spirv.empty());
  EXPECT_FALSE(
      compile_text("float4 Main(float2 u : TEXCOORD0) : SV_Target { return u.xyxy; }", hlsl::Stage::fragment)
          .spirv.empty());
  EXPECT_FALSE(compile_text(compute_shader("1")).spirv.empty());
}

TEST(Compile, DefinesReachTheSource) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = compute_shader("VALUE", "#if !defined(_KEYWORD)\n#error no keyword\n#endif\n");
  request.defines = {{"_KEYWORD", "1"}, {"VALUE", "(1.0 + 2.0)"}};
  EXPECT_TRUE(compile(request).diagnostics.empty());
  request.defines = {{"VALUE", "1"}};
  EXPECT_THAT(first_message(compile(request)), HasSubstr("shader.hlsl:2:1: error: '#error': no keyword"));
}

std::vector<std::string> errors_for(VulkanVersion vulkan, const std::string& text) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = text;
  request.vulkan = vulkan;
  const CompileResult result = compile(request);
  EXPECT_EQ(result.spirv.empty(), hlsl::has_errors(result.diagnostics));
  std::vector<std::string> messages;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) messages.push_back(diagnostic.message);
  return messages;
}

// Wave intrinsics belong to Vulkan 1.1 (GroupNonUniform, SPIR-V 1.3).
TEST(Compile, AVersionOfVulkanTakesWhatItHas) {
  const std::string waves = compute_shader("WaveActiveSum(1.0f)");
  for (const VulkanVersion vulkan : all_vulkan_versions)
    EXPECT_THAT(errors_for(vulkan, compute_shader("1")), testing::IsEmpty()) << vulkan_version_name(vulkan);
  EXPECT_THAT(errors_for(VulkanVersion::v1_1, waves), testing::IsEmpty());
  EXPECT_THAT(errors_for(VulkanVersion::v1_2, waves), testing::IsEmpty());
  EXPECT_THAT(errors_for(VulkanVersion::v1_0, waves),
              testing::Contains("SPIR-V validation for Vulkan 1.0: there is no capability GroupNonUniform"));
}

// The four offsets of a gather are constants in Vulkan; the front end takes others, and the validator
// refuses.
TEST(Compile, WhatTheValidatorRefusesIsShownAtItsLine) {
  const CompileResult result = compile_text(
      "Texture2D _Map; SamplerState sampler_Map; int2 _By;\nfloat4 Read(float2 uv)\n{\n    uv *= 2;\n"
      "    return _Map.GatherRed(sampler_Map, uv, _By, _By, _By, _By);\n}\n"
      "float4 Main(float4 p : SV_Position) : SV_Target\n{\n    return Read(p.xy);\n}\n",
      hlsl::Stage::fragment);
  EXPECT_TRUE(result.spirv.empty());
  EXPECT_THAT(first_message(result), AllOf(HasSubstr("shader.hlsl:5: error: SPIR-V validation"),
                                           HasSubstr("return _Map.GatherRed")));
}

// The second word of a module is its version of SPIR-V.
TEST(Compile, AModuleIsOfAVersionThatItsVulkanReads) {
  for (const auto& [vulkan, version] :
       {std::pair(VulkanVersion::v1_0, 0x00010000U), std::pair(VulkanVersion::v1_1, 0x00010300U),
        std::pair(VulkanVersion::v1_2, 0x00010300U)}) {
    CompileRequest request;
    request.file = "shader.hlsl";
    request.text = compute_shader("1");
    request.vulkan = vulkan;
    EXPECT_EQ(compile(request).spirv.at(1), version);
  }
}

TEST(Compile, TextureReachedThroughParametersIsLegal) {
  const std::string text =
      compute_shader("F(_A, sampler_A, 0.5)",
                     "Texture2D<float> _A;\nSamplerComparisonState sampler_A;\nfloat F(Texture2D<float> t, "
                     "SamplerComparisonState s, float x) { return t.SampleCmpLevelZero(s, x.xx, x); }\n");
  EXPECT_THAT(compile_text(text).diagnostics, testing::IsEmpty());
}

TEST(Compile, UnoptimisedKeepsItsFunctions) {
  const std::string text =
      compute_shader("Read(id.xy)", "Texture2D<float> _A;\nfloat Read(uint2 p) { return _A[p]; }\n");
  const auto functions = [](std::vector<std::uint32_t> words) {
    const spirv::Code code(std::move(words));
    std::vector<std::string> names;
    for (const spirv::Instruction& instruction : code.instructions())
      if (instruction.op == spv::OpFunction) names.push_back(code.name(instruction.result));
    return names;
  };
  EXPECT_THAT(functions(compile_text(text, hlsl::Stage::compute, false).spirv),
              testing::Contains(testing::StartsWith("Read(")));
  EXPECT_THAT(functions(compile_text(text).spirv), testing::SizeIs(1));
}

TEST(Compile, WhatIsKeptUnoptimisedIsWhatWasOptimised) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = compute_shader("Twice(id.x) + _In[id.xy]",
                                "Texture2D<float> _In;\nfloat Twice(float x) { return 2 * x; }\n");
  const std::vector<std::uint32_t> plain = compile(request).spirv;
  request.keep_unoptimised = true;
  const CompileResult both = compile(request);
  EXPECT_EQ(both.spirv, plain);
  request.keep_unoptimised = false;
  request.optimise = false;
  request.debug_lines = true;
  EXPECT_EQ(both.unoptimised, compile(request).spirv);
  EXPECT_NE(both.unoptimised, plain);
}

TEST(Compile, EmptyFileHasNoEntryPoint) {
  const CompileResult result = compile_text("");
  EXPECT_TRUE(result.spirv.empty());
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(first_message(result), "shader.hlsl: error: the entry point 'Main' is not defined");
}

TEST(Compile, FileWithoutTheEntryPointSaysWhichIsMissing) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = compute_shader("1");
  request.entry = "Mian";
  const CompileResult result = compile(request);
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(first_message(result), "shader.hlsl: error: the entry point 'Mian' is not defined");
}

TEST(Compile, ByteOrderMarkAndCrLfChangeNothing) {
  const std::string plain = compute_shader("TWICE(2)", "#define TWICE(x) \\\n  ((x) + (x))\n");
  std::string dos = "\xEF\xBB\xBF";
  for (const char c : plain) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(compile_text(plain).diagnostics.empty());
  EXPECT_EQ(compile_text(dos).spirv, compile_text(plain).spirv);
  EXPECT_THAT(first_message(compile_text("\xEF\xBB\xBF\r\nfloat f() {\r\n  return $;\r\n}\r\n")),
              HasSubstr("shader.hlsl:3:10: error: unexpected token '$'\n      return $;\n             ^"));
}

TEST(Compile, BytesThatAreNoUtf8DoNoHarmInCommentsAndAreErrorsInCode) {
  EXPECT_TRUE(compile_text("// \xE9\xFF\xFE\n" + compute_shader("1")).diagnostics.empty());
  const CompileResult result = compile_text("float \xE9;\n" + compute_shader("1"));
  EXPECT_TRUE(result.spirv.empty());
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics.front().line, 1);
}

TEST(Compile, NulByteIsAnError) {
  const CompileResult result = compile_text(compute_shader("1") + std::string("\n\0 garbage", 10));
  EXPECT_TRUE(result.spirv.empty());
  EXPECT_THAT(
      first_message(result),
      HasSubstr("shader.hlsl:8:1: error: a NUL byte: save this file as text in UTF-8; UTF-16 is not read"));
}

TEST(Compile, WarningsAreKeptOnce) {
  const std::string function =
      "float F(float x)\n{\n    [odd] if (x > 1) x = 2; [odd] if (x > 2) x = 3;\n    return x;\n}\n";
  const CompileResult result = compile_text(compute_shader("F(1)", function));
  EXPECT_FALSE(result.spirv.empty());
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics.front().severity, hlsl::Severity::warning);
  EXPECT_THAT(first_message(result), HasSubstr("shader.hlsl:3: warning: unrecognized attribute 'odd'"));
}

TEST(Compile, SameBytesFromFourThreadsAsFromOne) {
  std::vector<std::string> texts;
  texts.reserve(8);
  for (int i = 0; i < 8; ++i)
    texts.push_back(compute_shader("sin(" + std::to_string(i) + ".5 + id.x)" + (i % 4 == 3 ? " $" : "")));
  std::vector<CompileResult> expected;
  expected.reserve(texts.size());
  for (const std::string& text : texts) expected.push_back(compile_text(text));
  std::atomic<int> differences{0};
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (int round = 0; round < 5; ++round)
        for (std::size_t i = 0; i < texts.size(); ++i) {
          const CompileResult result = compile_text(texts[i]);
          if (result.spirv != expected[i].spirv || first_message(result) != first_message(expected[i]))
            ++differences;
        }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(differences, 0);
  EXPECT_FALSE(expected[0].spirv.empty());
  EXPECT_TRUE(expected[3].spirv.empty());
}

}  // namespace
}  // namespace penumbra::shaders
