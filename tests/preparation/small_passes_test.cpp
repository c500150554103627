// Tests stray semicolons and the precision of textures: what goes, and what must stay.
#include <gmock/gmock.h>

#include "preparation/after_pass.h"
#include "preparation/passes.h"
#include "preparation/prepare.h"
#include "shaders/compile.h"

namespace penumbra::preparation {
namespace {

TEST(StraySemicolons, GoAtFileScopeAndAmongMembers) {
  const auto run = after<drop_stray_semicolons>;
  EXPECT_EQ(run("; float a;; ; float b;"), "float a; float b;");
  EXPECT_EQ(run("cbuffer C { float a;; float b; } ; struct S { ; float f() { ; ; return 1; }; float c; };"),
            "cbuffer C { float a; float b; } struct S { float f() { ; ; return 1; } float c; };");
}

TEST(StraySemicolons, ThoseThatEndSomethingStay) {
  for (const char* text : {"float a; float b;", "struct S { float a; };", "void f() { ; for (;;) { } }",
                           "struct S { float a; } s;", "float f(); float f() { ; }"})
    EXPECT_EQ(after<drop_stray_semicolons>(text), text);
}

TEST(TexturePrecision, TheTypeLosesIt) {
  EXPECT_EQ(after<drop_texture_precision>("Texture2D_half a; TextureCubeArray_float b; sampler2D_half c;"),
            "Texture2D a; TextureCubeArray b; sampler2D c;");
  EXPECT_EQ(after<drop_texture_precision>("float my_half; Texture2D_other d; _half e;"),
            "float my_half; Texture2D_other d; _half e;");
}

TEST(PrecisionMatrices, AreThoseThatGlslangKnows) {
  EXPECT_EQ(after<name_precision_matrices>(
                "min16float3x3 a; min10float2x4 b; min16int4x4 c; min12int2x2 d; min16uint3x4 e;"),
            "half3x3 a; half2x4 b; int4x4 c; int2x2 d; uint3x4 e;");
  const std::string others =
      "min16float a; min16float3 b; half3x3 c; float4x4 min16float3x5; x.min16floats3x3; min16float3x33 d;";
  EXPECT_EQ(after<name_precision_matrices>(others), others);
}

shaders::CompileResult compile_text(const std::string& text, bool prepare) {
  shaders::CompileRequest request;
  request.file = "small.hlsl";
  request.text = text;
  request.prepare = prepare;
  return shaders::compile(request);
}

// Each text is refused without the stage and accepted with it, without a word.
TEST(Preparation, LetsThroughWhatUnityCompilersAccept) {
  const std::string main = "RWStructuredBuffer<float4> O; [numthreads(1, 1, 1)] void Main() { O[0] = V; }\n";
  for (const std::string& declarations :
       {std::string("struct S { float a;; };\nstatic const float4 V = 1;\n"),
        std::string("cbuffer C { float4 V;; };\n"), std::string("static const float4 V = 1h;\n"),
        std::string("#define T(n) n\nTexture2D_half T(t);\n#define V t.Load(0)\n")}) {
    const shaders::CompileResult without = compile_text(declarations + main, false);
    const shaders::CompileResult with = compile_text(declarations + main, true);
    EXPECT_FALSE(without.diagnostics.empty()) << declarations;
    EXPECT_TRUE(with.diagnostics.empty()) << declarations << format(with.diagnostics.at(0));
    EXPECT_FALSE(with.spirv.empty()) << declarations;
  }
}

TEST(Preparation, PassesHaveNamesOfTheirOwn) {
  for (const Pass& a : passes())
    for (const Pass& b : passes()) EXPECT_EQ(&a == &b, std::string(a.name) == b.name);
}

TEST(MissingReturns, OnlyFunctionsWithoutAnyReturnGetOne) {
  const auto run = after<return_from_empty_functions>;
  EXPECT_EQ(run("static float2 f(float x) { x += 1; }"),
            "static float2 f(float x) { x += 1; return (float2)0; }");
  for (const char* text : {"void f() { }", "float f() { if (a) return 1; }", "float f();",
                           "struct S { float a; };", "float f() { a); return 1; }"})
    EXPECT_EQ(run(text), text);
  EXPECT_EQ(run("SamplerState f() { } Texture2D<float4> g(int i) { } float h();"), "float h();");
  const std::string called = "SamplerState f() { } float4 h(Texture2D t) { return t.Sample(f(), 0); }";
  EXPECT_EQ(run(called), called);
}

}  // namespace
}  // namespace penumbra::preparation
