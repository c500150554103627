// Modules that are valid SPIR-V and no valid HLSL are refused at the line, and what is never run is no error.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shader_files.h"
#include "shaders/compile.h"

namespace penumbra::shaders {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kResources =
    "Texture2D<float4> _Map; SamplerState sampler_Map; SamplerComparisonState _Compare; int _N; int2 "
    "_Texel;\n";

std::vector<std::string> errors(const std::string& text, hlsl::Stage stage) {
  CompileRequest request;
  request.file = "a";
  request.text = kResources + text;
  request.stage = stage;
  const CompileResult result = compile(request);
  EXPECT_EQ(result.spirv.empty(), !result.diagnostics.empty());
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& said : result.diagnostics)
    all.push_back(std::to_string(said.line) + ": " + said.message);
  return all;
}

// `body` begins in line 3.
std::vector<std::string> fragment(const std::string& body) {
  return errors("float4 Main(float4 p : SV_Position) : SV_Target {\n" + body + "\n}\n",
                hlsl::Stage::fragment);
}
std::vector<std::string> vertex(const std::string& body, const std::string& before = "") {
  return errors(before + "float4 Main(float4 p : POSITION) : SV_Position {\n" + body + "\n}\n",
                hlsl::Stage::vertex);
}

TEST(Derivatives, AreOfFragmentProgramsAlone) {
  EXPECT_THAT(
      vertex("return _Map.Sample(sampler_Map, p.xy);"),
      ElementsAre("3: a texture is sampled with derivatives, which a vertex program does not have: use "
                  "SampleLevel or SampleGrad"));
  EXPECT_THAT(vertex("return _Map.SampleBias(sampler_Map, p.xy, 1);"),
              ElementsAre(HasSubstr("3: a texture is")));
  EXPECT_THAT(vertex("return _Map.SampleCmp(_Compare, p.xy, 1);"), ElementsAre(HasSubstr("3: a texture is")));
  EXPECT_THAT(vertex("return ddx(p);"),
              ElementsAre("3: ddx needs derivatives, which a vertex program does not have"));
  EXPECT_THAT(
      vertex("return _Map.CalculateLevelOfDetail(sampler_Map, p.xy);"),
      ElementsAre("3: CalculateLevelOfDetail needs derivatives, which a vertex program does not have"));
  EXPECT_THAT(
      vertex("return Read(p.xy);", "float4 Read(float2 uv) {\nreturn _Map.Sample(sampler_Map, uv); }\n"),
      ElementsAre(HasSubstr("3: a texture is sampled with derivatives")));
  EXPECT_THAT(
      errors("RWTexture2D<float4> _Out;\n[numthreads(8, 8, 1)] void Main(uint3 id : SV_DispatchThreadID) {\n"
             "_Out[id.xy] = _Map.Sample(sampler_Map, id.xy); }\n",
             hlsl::Stage::compute),
      ElementsAre(HasSubstr("4: a texture is sampled with derivatives, which a compute program")));
}

TEST(Derivatives, MayStandWhereNothingReadsThem) {
  const std::string read = "float4 Read(float2 uv) {\nreturn _Map.Sample(sampler_Map, uv); }\n";
  EXPECT_THAT(vertex("return _Map.SampleLevel(sampler_Map, p.xy, 0);", read), IsEmpty());
  EXPECT_THAT(vertex("float4 unused = Read(p.xy);\nif (false) p = Read(p.xy);\nreturn p;", read), IsEmpty());
  EXPECT_THAT(
      vertex("return _Map.SampleCmpLevelZero(_Compare, p.xy, 1) + _Map.SampleGrad(sampler_Map, 0, 0, 0);"),
      IsEmpty());
  EXPECT_THAT(fragment("return ddx(p) + _Map.Sample(sampler_Map, p.xy);"), IsEmpty());
}

TEST(TexelOffsets, AreConstantsFromMinus8To7) {
  EXPECT_THAT(fragment("return _Map.Sample(sampler_Map, p.xy, int2(0, 8));"),
              ElementsAre("3: the offset of a texture read is 8 texels, and must be from -8 to 7"));
  EXPECT_THAT(fragment("return _Map.SampleGrad(sampler_Map, p.xy, 0, 0, int2(-9, 0));"),
              ElementsAre("3: the offset of a texture read is -9 texels, and must be from -8 to 7"));
  EXPECT_THAT(fragment("return _Map.SampleCmpLevelZero(_Compare, p.xy, 0, int2(9, 0));"),
              ElementsAre(HasSubstr("3: the offset of a texture read is 9 texels")));
  EXPECT_THAT(fragment("return _Map.Load(int3(p.xy, 0), int2(8, 1));"),
              ElementsAre(HasSubstr("3: the offset of a texture read is 8 texels")));
  EXPECT_THAT(
      fragment("return _Map.Sample(sampler_Map, p.xy, _Texel);"),
      ElementsAre(HasSubstr("3: the offset of a texture read must be a constant from -8 to 7; if a loop")));
}

TEST(TexelOffsets, AreFreeForGatherAndMayBeWorkedOut) {
  EXPECT_THAT(
      fragment(
          "return _Map.Gather(sampler_Map, p.xy, int2(9, 0)) + _Map.Sample(sampler_Map, p.xy, int2(-8, 7));"),
      IsEmpty());
  EXPECT_THAT(
      fragment("float4 sum = 0; [unroll] for (int i = -2; i <= 2; ++i) sum += _Map.Sample(sampler_Map, p.xy, "
               "int2(i, 0));\nreturn sum;"),
      IsEmpty());
}

TEST(IntegerDivisions, ByAConstantZeroAreRefused) {
  EXPECT_THAT(fragment("return _N / 0;"), ElementsAre("3: an integer is divided by zero"));
  EXPECT_THAT(fragment("int2 a = _Texel % int2(1, 0);\nreturn a.xyxy;"),
              ElementsAre("3: an integer is divided by zero"));
  EXPECT_THAT(fragment("const uint zero = 3 - 3;\nreturn (uint)_N / zero;"),
              ElementsAre("4: an integer is divided by zero"));
}

TEST(IntegerDivisions, ByZeroAreNoErrorWhereTheyAreNeverMade) {
  EXPECT_THAT(
      fragment(
          "const int zero = 0;\nif (zero != 0) return _N / zero;\nint unused = _N / 0;\nreturn _N / 2.0 / "
          "0.0 + _N % 3;"),
      IsEmpty());
}

TEST(ComparisonSamplers, AreForReadsThatCompare) {
  EXPECT_THAT(fragment("return _Map.Sample(_Compare, p.xy);"),
              ElementsAre(HasSubstr("3: '_Compare' is a comparison sampler and this read does not compare")));
  EXPECT_THAT(fragment("return _Map.SampleCmp(sampler_Map, p.xy, 1);"),
              ElementsAre("3: expected: SamplerComparisonState"));
}

TEST(LostTextures, AreReportedAtTheirLine) {
  EXPECT_THAT(fragment("Texture2D t;\nreturn t.Load(0);"),
              ElementsAre(HasSubstr("4: a texture that was never set")));
}

// `body` begins in line 6.
std::vector<std::string> calling(const std::string& body) {
  return errors(
      "void F(inout float x) { x += 1; }\nvoid G(float a, out float2 b) { b = a; }\n"
      "struct S { float m; float4 n[2]; };\nfloat4 Main(float4 p : SV_Position) : SV_Target {\n" +
          body + "\n}\n",
      hlsl::Stage::fragment);
}

TEST(WrittenArguments, AreNoValues) {
  const auto told = [](const std::string& function, const std::string& argument) {
    return ElementsAre("6: '" + function + "' writes to its argument " + argument +
                       ", which is a value: give it a variable");
  };
  EXPECT_THAT(calling("F(1.0); return 1;"), told("F", "1"));
  EXPECT_THAT(calling("F(p.x + 1); return 1;"), told("F", "1"));
  EXPECT_THAT(calling("F(-p.x); return 1;"), told("F", "1"));
  EXPECT_THAT(calling("const float k = 2; F(k); return 1;"), told("F", "1"));
  EXPECT_THAT(calling("G(1, float2(1, 2)); return 1;"), told("G", "2"));
}

// HLSL has no objection; glslang crashes.
TEST(WrittenArguments, OfAnotherTypeAreToldInsteadOfCrashing) {
  EXPECT_THAT(
      calling("int i = 1; F(i); return i;"),
      ElementsAre("6: 'F' writes to its argument 1, which is of another type: give it a variable of the "
                  "parameter's type"));
}

TEST(WrittenArguments, AreVariablesAndTheirParts) {
  EXPECT_THAT(calling("float v = 1; F(v); float4 w = 1; F(w.y); F(w[_N]); float a[2] = { 1, 2 }; F(a[_N]);\n"
                      "S s = (S)0; F(s.m); F(s.n[_N].z); int i = 1; float2 g; G(i + 1, g); G(1, w.zy);\n"
                      "return v + w + a[0] + s.n[1] + i + g.xyxy;"),
              IsEmpty());
}

}  // namespace
}  // namespace penumbra::shaders
