// Sends one module through all rules: places in other files, order, duplicates, and input that is no module.
#include "lint/module_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "lint/linted_shader.h"
#include "shaders/shader_files.h"

namespace penumbra::lint {
namespace {

using shaders::ShaderFiles;
using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;
using testing::StartsWith;

std::vector<hlsl::Diagnostic> lint_file(const shaders::CompileRequest& given) {
  shaders::CompileRequest request = given;
  request.optimise = false;
  request.debug_lines = true;
  shaders::CompileResult result = shaders::compile(request);
  return lint_module({result.spirv, request.stage, request.file.string(), result.sources, 0});
}

constexpr const char* part = "\nfloat Edge(float x)\n{\n    if (x > 0.5) x += ddx(x);\n    return x;\n}\n";

TEST(LintModule, AFindingInAnIncludedFileIsThere) {
  const ShaderFiles files;
  files.write("Part.hlsl", part);
  files.write("Main.hlsl", "#include \"Part.hlsl\"\n" + fragment("", "Edge(uv.x)"));
  const std::vector<hlsl::Diagnostic> found = lint_file(files.request("Main.hlsl", hlsl::Stage::fragment));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].file, EndsWith("Part.hlsl"));
  EXPECT_THAT(told(found[0]), StartsWith("4:23 warning divergent-derivative: "));
  EXPECT_EQ(found[0].source_line, "    if (x > 0.5) x += ddx(x);");
}

TEST(LintModule, ASuppressionInAnIncludedFileCounts) {
  const ShaderFiles files;
  files.write("Part.hlsl", std::string("// penumbra-lint: disable-file=divergent-derivative") + part);
  files.write("Main.hlsl", "#include \"Part.hlsl\"\n" + fragment("", "Edge(uv.x)"));
  EXPECT_THAT(lint_file(files.request("Main.hlsl", hlsl::Stage::fragment)), IsEmpty());
}

TEST(LintModule, PlacesHoldWhenPrecisionTwinsAreMerged) {
  const ShaderFiles files;
  files.write("Part.hlsl", part);
  files.write("Main.hlsl",
              "half Twin(half x) { return x; }\nfloat Twin(float x) { return x; }\n#include \"Part.hlsl\"\n" +
                  fragment("    if (uv.y > 0.5) uv.x += ddx(uv.y);\n", "Edge(uv.x)"));
  shaders::CompileRequest request = files.request("Main.hlsl", hlsl::Stage::fragment);
  request.prepare = true;
  std::vector<std::string> places;
  for (const hlsl::Diagnostic& finding : lint_file(request))
    places.push_back(std::filesystem::path(finding.file).filename().string() + ":" +
                     std::to_string(finding.line));
  EXPECT_THAT(places, ElementsAre("Main.hlsl:6", "Part.hlsl:4"));
}

TEST(LintModule, AFunctionCalledTwiceSpeaksOnce) {
  EXPECT_EQ(lint(fragment("", "Edge(uv.x) + Edge(uv.y)", part)).size(), 1U);
}

TEST(LintModule, FindingsStandInTheOrderOfLines) {
  const std::string text =
      part + fragment("", "_Map.Sample(_Wrong, Edge(uv.x))", "Texture2D _Map;\nSamplerState _Wrong;\n");
  std::vector<std::string> rules;
  for (const hlsl::Diagnostic& finding : lint(text)) rules.push_back(finding.rule);
  EXPECT_THAT(rules, ElementsAre("divergent-derivative", "sampler-name"));
}

TEST(LintModule, WordsThatAreNoModule) {
  EXPECT_THROW(lint_module({{}, hlsl::Stage::fragment, "a", {}, 0}), std::invalid_argument);
  EXPECT_THROW(lint_module({{1, 2, 3, 4, 5, 6}, hlsl::Stage::fragment, "a", {}, 0}), std::invalid_argument);
  std::vector<std::uint32_t> cut = compiled(fragment("", "1")).spirv;
  cut.resize(cut.size() - 2);  // the module is cut within the return before the function's end
  EXPECT_THROW(lint_module({cut, hlsl::Stage::fragment, "a", {}, 0}), std::invalid_argument);
  cut[3] = 0xFFFFFFFFU;
  EXPECT_THROW(lint_module({cut, hlsl::Stage::fragment, "a", {}, 0}), std::invalid_argument)
      << "a bound of 2^32";
}

TEST(LintModule, WhatIsTooLargeIsSaidAndNotFollowed) {
  const auto writes = [](int count, const std::string& name) {
    std::string text = "void " + name + "(uint i : SV_GroupIndex)\n{\n";
    for (int n = 0; n < count; ++n) text += "    if (i > " + std::to_string(n) + ") _Out[i] = 1;\n";
    return text + "}\n";
  };
  const std::string head = "RWStructuredBuffer<float> _Out;\n";
  const std::string threads = "[numthreads(8, 1, 1)] ";
  EXPECT_THAT(told(lint(head + threads + writes(2'100, "Main"), hlsl::Stage::compute)),
              ElementsAre("0 note not-checked: the shader is too large for the rules that need it inlined"));
  EXPECT_THAT(
      told(lint(
          head + writes(150, "Part") +
              "void Parts(uint i) { Part(i); Part(i + 1); Part(i + 2); Part(i + 3); }\n" + threads +
              "void Main(uint i : SV_GroupIndex) { Parts(i); Parts(i * 2); Parts(i * 3); Parts(i * 5); }\n",
          hlsl::Stage::compute)),
      ElementsAre("0 note not-checked: the shader is too large for the rules that analyse its control flow"));
}

TEST(LintModule, EveryStageIsTaken) {
  EXPECT_THAT(lint("RWStructuredBuffer<float> _Out;\n[numthreads(8, 1, 1)]\nvoid Main(uint3 id : "
                   "SV_DispatchThreadID)\n"
                   "{\n    _Out[id.x] = id.x;\n}\n",
                   hlsl::Stage::compute),
              IsEmpty());
  const std::string hull =
      "struct C { float4 p : POSITION; };\nstruct F { float e[3] : SV_TessFactor; float i : "
      "SV_InsideTessFactor; };\n"
      "F Factors(InputPatch<C, 3> patch) { F f; f.e[0] = f.e[1] = f.e[2] = 2; f.i = 2; return f; }\n"
      "[domain(\"tri\")]\n[partitioning(\"integer\")]\n[outputtopology(\"triangle_cw\")]\n["
      "outputcontrolpoints(3)]\n"
      "[patchconstantfunc(\"Factors\")]\nC Main(InputPatch<C, 3> patch, uint id : SV_OutputControlPointID)\n"
      "{\n    return patch[id];\n}\n";
  EXPECT_THAT(lint(hull, hlsl::Stage::hull), IsEmpty());
}

}  // namespace
}  // namespace penumbra::lint
