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

std::vector<hlsl::Diagnostic> lint_file(const shaders::CompileRequest& given) {
  shaders::CompileRequest request = given;
  request.optimise = false;
  request.debug_lines = true;
  shaders::CompileResult result = shaders::compile(request);
  return lint_module({result.spirv, request.stage, request.file.string(), result.sources, 0});
}

constexpr const char* part = "\nfloat Bent(float x)\n{\n    return pow(x, 1.5);\n}\n";

TEST(LintModule, AFindingInAnIncludedFileIsThere) {
  const ShaderFiles files;
  files.write("Part.hlsl", part);
  files.write("Main.hlsl", "#include \"Part.hlsl\"\n" + fragment("", "Bent(uv.x)"));
  const std::vector<hlsl::Diagnostic> found = lint_file(files.request("Main.hlsl", hlsl::Stage::fragment));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].file, EndsWith("Part.hlsl"));
  EXPECT_EQ(told(found[0]).substr(0, 25), "4:12 warning negative-pow");
  EXPECT_EQ(found[0].source_line, "    return pow(x, 1.5);");
}

TEST(LintModule, ASuppressionInAnIncludedFileCounts) {
  const ShaderFiles files;
  files.write("Part.hlsl", std::string("// penumbra-lint: disable-file=negative-pow") + part);
  files.write("Main.hlsl", "#include \"Part.hlsl\"\n" + fragment("", "Bent(uv.x)"));
  EXPECT_THAT(lint_file(files.request("Main.hlsl", hlsl::Stage::fragment)), IsEmpty());
}

TEST(LintModule, PlacesHoldWhenPrecisionTwinsAreMerged) {
  const ShaderFiles files;
  files.write("Part.hlsl", part);
  files.write("Main.hlsl",
              "half Twin(half x) { return x; }\nfloat Twin(float x) { return x; }\n#include \"Part.hlsl\"\n" +
                  fragment("", "Bent(uv.x) + pow(uv.y, 1.5)"));
  shaders::CompileRequest request = files.request("Main.hlsl", hlsl::Stage::fragment);
  request.prepare = true;
  std::vector<std::string> places;
  for (const hlsl::Diagnostic& finding : lint_file(request))
    places.push_back(std::filesystem::path(finding.file).filename().string() + ":" +
                     std::to_string(finding.line));
  EXPECT_THAT(places, ElementsAre("Main.hlsl:6", "Part.hlsl:4"));
}

TEST(LintModule, AFunctionCalledTwiceSpeaksOnce) {
  EXPECT_EQ(lint(fragment("", "Bent(uv.x) + Bent(uv.y)", part)).size(), 1U);
}

TEST(LintModule, FindingsStandInTheOrderOfLines) {
  const std::string text = fragment("    float a;\n    float b = pow(uv.x, 1.5);\n", "a + b");
  std::vector<std::string> rules;
  for (const hlsl::Diagnostic& finding : lint(text)) rules.push_back(finding.rule);
  EXPECT_THAT(rules, ElementsAre("negative-pow", "read-before-set"));
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
  std::string statements = "    float a;\n";
  for (int i = 0; i < 2'100; ++i) statements += "    if (uv.x > " + std::to_string(i) + ") a = uv.y;\n";
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& finding : lint(fragment(statements, "a"))) all.push_back(told(finding));
  EXPECT_THAT(
      all, ElementsAre("0 note not-checked: the shader is too large for the rules that need it inlined",
                       "1:8 note not-checked: 'Main' is too large for data-flow analysis of its variables"));
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
