// Constructs that some targets cannot express are reported at their line, and a driver accepts what
// SPIRV-Cross writes wrongly.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shaders/compile.h"
#include "shaders/cross_compile.h"
#include "shaders/gl_check.h"

namespace penumbra::shaders {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

CompileResult compiled_for_targets(const std::string& text, hlsl::Stage stage = hlsl::Stage::fragment) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = text;
  request.stage = stage;
  request.prepare = true;
  return compile(request);
}

// The messages as "target: line: message".
std::vector<std::string> of_targets(const CompileResult& result) {
  std::vector<std::string> all;
  for (const TargetDiagnostics& of : result.of_targets)
    for (const hlsl::Diagnostic& diagnostic : of.diagnostics)
      all.push_back(of.target + ": " + std::to_string(diagnostic.line) + ": " + diagnostic.message);
  return all;
}

TEST(TargetProblems, OfWaveFunctionsAreReportedAtTheirLine) {
  const std::string text =
      "float4 Main(float2 uv : TEXCOORD0) : SV_Target {\nfloat f = uv.x;\nreturn WaveActiveSum(f); }";
  EXPECT_THAT(of_targets(compiled_for_targets(text)),
              ElementsAre(StartsWith("essl300: 3: wave functions need"), StartsWith("essl310: 3: "),
                          StartsWith("glsl410: 3: "), StartsWith("glsl450: 3: "), StartsWith("hlsl50: 3: "),
                          StartsWith("hlsl51: 3: ")));
}

TEST(TargetProblems, OfInterpolationAreThoseOfOpenGlEs) {
  const CompileResult result = compiled_for_targets(
      "float4 Main(float2 uv : TEXCOORD0) : SV_Target {\nreturn EvaluateAttributeAtSample(uv, 0).xyxy; }");
  EXPECT_THAT(of_targets(result),
              ElementsAre(StartsWith("essl300: 2: the EvaluateAttribute functions need OpenGL ES 3.2"),
                          StartsWith("essl310: 2: ")));
  const CrossCompileResult emitted = cross_compile(result.spirv, Target::glsl450);
  EXPECT_THAT(gl_check({{hlsl::Stage::fragment, emitted.text}}, Target::glsl450), IsEmpty()) << emitted.text;
}

TEST(TargetProblems, OfFineDerivativesAreThoseOfOpenGlEs) {
  EXPECT_THAT(of_targets(compiled_for_targets("float4 Main(float2 uv : TEXCOORD0) : SV_Target {\n"
                                              "return ddx_fine(uv.x) + ddx(uv.y); }")),
              ElementsAre(StartsWith("essl300: 2: OpenGL ES has no fine and coarse derivatives"),
                          StartsWith("essl310: 2: ")));
}

TEST(TargetProblems, OfArraysOfConstantBuffersAreThoseOfShaderModel5) {
  EXPECT_THAT(of_targets(compiled_for_targets(
                  "struct L { float4 a; };\nConstantBuffer<L> one;\nConstantBuffer<L> c[2];\n"
                  "float4 Main(float2 uv : TEXCOORD0) : SV_Target { return c[1].a + one.a; }")),
              ElementsAre(StartsWith("hlsl50: 3: 'c' is an array of constant buffers")));
}

TEST(TargetProblems, OfImagesThatOpenGlEsDoesNotHaveAreAtTheirDeclaration) {
  const std::string main =
      "RWTexture2D<float2> _A;\nRWTexture2D<float4> _B;\nRWTexture2D<float4> _C; RWTexture2D<float> _D;\n"
      "[numthreads(8, 8, 1)] void Main(uint3 id : SV_DispatchThreadID) { _A[id.xy] = id.xy;\n"
      "_B[id.xy] = _B[id.xy] * 0.5; _C[id.xy] = _D[id.xy]; _D[id.xy] = 1; }";
  EXPECT_THAT(of_targets(compiled_for_targets(main, hlsl::Stage::compute)),
              ElementsAre(StartsWith("essl300: 1: '_A' has a format that OpenGL ES does not have"),
                          StartsWith("essl300: 2: '_B' is read and written"), StartsWith("essl310: 1: '_A'"),
                          StartsWith("essl310: 2: '_B'")));
}

TEST(TargetProblems, OfSizesOfBuffersAreThoseOfMetal) {
  const auto asking = [](const std::string& buffer, const std::string& outputs) {
    return of_targets(compiled_for_targets(
        buffer +
            " b;\nRWStructuredBuffer<uint> o;\n[numthreads(1, 1, 1)] void Main() {\nuint n, s = 1; "
            "b.GetDimensions(" +
            outputs + ");\no[0] = n * s; }",
        hlsl::Stage::compute));
  };
  const auto of_metal = ElementsAre(StartsWith("msl20: 4: Metal has no GetDimensions"),
                                    StartsWith("msl22: 4: "), StartsWith("msl23: 4: "));
  EXPECT_THAT(asking("StructuredBuffer<float4>", "n, s"), of_metal);
  EXPECT_THAT(asking("Buffer<float4>", "n"), of_metal);
  EXPECT_THAT(asking("RWBuffer<float>", "n"), of_metal);
  EXPECT_THAT(asking("Texture2D", "n, s"), IsEmpty());
}

TEST(TargetProblems, OfGathersAtVariableOffsetsAreThoseOfOpenGlEs) {
  const std::string head = "Texture2D t; SamplerState s;\nfloat4 Main(float4 v : TEXCOORD0) : SV_Target {\n";
  EXPECT_THAT(of_targets(compiled_for_targets(head + "return t.GatherRed(s, v.xy, int2(v.zw)); }")),
              ElementsAre(StartsWith("essl300: 3: a gather with an offset that is not constant"),
                          StartsWith("essl310: 3: ")));
  const CompileResult constant = compiled_for_targets(
      head + "return t.GatherRed(s, v.xy, int2(0, 1), int2(1, 0), int2(2, -1), int2(0, 0)); }");
  EXPECT_THAT(of_targets(constant), IsEmpty());
  const CrossCompileResult emitted = cross_compile(constant.spirv, Target::essl310);
  EXPECT_THAT(gl_check({{hlsl::Stage::fragment, emitted.text}}, Target::essl310), IsEmpty()) << emitted.text;
  for (const Target target : {Target::msl23, Target::hlsl50})
    EXPECT_THAT(cross_compile(constant.spirv, target).text, testing::HasSubstr("int2(2, -1)"));
}

TEST(TargetProblems, AreThoseOfCodeThatRuns) {
  EXPECT_THAT(of_targets(compiled_for_targets(
                  "float4 F(float f) { return WaveActiveSum(f); }\nfloat4 Main(float2 uv : "
                  "TEXCOORD0) : SV_Target { return ddx(uv).xyxy; }")),
              IsEmpty());
}

TEST(ClipDistances, AreRequestedInEssl) {
  const std::string output =
      "struct V { float4 p : SV_Position; float c : SV_ClipDistance0; float d : SV_CullDistance0; };";
  const std::pair<std::string, hlsl::Stage> shaders[] = {
      {output + "V Main(float4 v : POSITION) { V o; o.p = v; o.c = v.x; o.d = v.y; return o; }",
       hlsl::Stage::vertex},
      {"float4 Main(float4 v : SV_Position, float2 c : SV_ClipDistance0) : SV_Target { return c.xyxy; }",
       hlsl::Stage::fragment}};
  for (const auto& [text, stage] : shaders) {
    const CrossCompileResult emitted =
        cross_compile(compiled_for_targets(text, stage).spirv, Target::essl310);
    EXPECT_THAT(gl_check({{stage, emitted.text}}, Target::essl310), IsEmpty()) << emitted.text;
  }
}

}  // namespace
}  // namespace penumbra::shaders
