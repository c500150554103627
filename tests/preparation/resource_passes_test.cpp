// Tests the passes over textures, samplers and buffers: what they put where, and that it compiles.
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "preparation/dx9_functions.h"
#include "preparation/passes.h"
#include "preparation/prepare.h"
#include "processor_time.h"
#include "shaders/compile.h"

namespace penumbra::preparation {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Passed {
  std::string text;  // the tokens with one blank between them
  std::vector<Note> notes;
};

std::string blank_separated(const std::string& hlsl) {
  std::string text;
  for (const hlsl::Token& token : hlsl::lex(hlsl)) text += std::string(token.spelling) + " ";
  return text;
}

Passed pass(void (*run)(TokenText&), const std::string& hlsl) {
  TokenText text(hlsl, "m.hlsl");
  run(text);
  return {blank_separated(text.print()), text.notes()};
}

void expect(void (*run)(TokenText&), const std::string& before, const std::string& after) {
  const Passed passed = pass(run, before);
  EXPECT_EQ(passed.text, blank_separated(after));
  EXPECT_THAT(passed.notes, IsEmpty());
}

void expect_untouched(void (*run)(TokenText&), const std::string& hlsl) {
  expect(run, hlsl, hlsl);
}

void expect_error(void (*run)(TokenText&), const std::string& hlsl, const std::string& part) {
  const Passed passed = pass(run, hlsl);
  ASSERT_THAT(passed.notes, SizeIs(1)) << hlsl;
  EXPECT_EQ(passed.notes[0].severity, hlsl::Severity::error);
  EXPECT_EQ(passed.notes[0].line, 1);
  EXPECT_THAT(passed.notes[0].message, HasSubstr(part));
}

TEST(BufferAliases, AreTheBufferItself) {
  expect(resolve_buffer_aliases,
         "StructuredBuffer<int> A; struct S { StructuredBuffer<int> b; float x; };"
         "void fill(StructuredBuffer<int> p, out S s) { s.b = p; s.x = 1; }"
         "int f() { S s; fill(A, s); StructuredBuffer<int> l = s.b; return s.b[1] + l[2]; }",
         "StructuredBuffer<int> A; struct S { float x; };"
         "void fill(StructuredBuffer<int> p, out S s) { ; s.x = 1; }"
         "int f() { S s; fill(A, s); return A[1] + A[2]; }");
  expect_untouched(resolve_buffer_aliases,
                   "StructuredBuffer<int> A; int g(StructuredBuffer<int> p) { return p[0]; }");
}

TEST(BufferAliases, OfABufferDeclaredLaterBringItBeforeTheirUse) {
  const std::string type = "struct E { int x; }; ";
  expect(resolve_buffer_aliases,
         type +
             "struct S { StructuredBuffer<E> b, c; float x; }; int n;"
             "int early(S s) { return s.b[0].x + s.b[1].x; } int second(S s) { return s.c[2].x; }"
             "int between; StructuredBuffer<E> A : register(t1), C : register(t2); StructuredBuffer<E> D;"
             "S make() { S s; s.b = A; s.c = C; s.x = 1; return s; } int late(S s) { return s.b[3].x; }",
         type +
             "struct S { float x; }; int n;"
             "StructuredBuffer<E> A : register(t1), C : register(t2);"
             "int early(S s) { return A[0].x + A[1].x; } int second(S s) { return C[2].x; }"
             "int between; StructuredBuffer<E> D;"
             "S make() { S s; ; ; s.x = 1; return s; } int late(S s) { return A[3].x; }");
}

TEST(BufferAliases, OfABufferDeclaredLaterCompileAndKeepItsLine) {
  const PreparedShader prepared = prepare(
      "struct E { int x; };\nstruct S { StructuredBuffer<E> b; };\nint early(S s) { return s.b[0].x; }\n"
      "StructuredBuffer<E> A;\nRWStructuredBuffer<int> Out;\n"
      "[numthreads(1, 1, 1)] void Main() { S s; s.b = A; Out[0] = early(s); }\n",
      "m.hlsl");
  EXPECT_THAT(prepared.notes, IsEmpty());
  TokenText text(prepared.text, "m.hlsl");
  const auto& tokens = text.tokens();
  const auto buffer = std::find_if(tokens.begin(), tokens.end(),
                                   [](const hlsl::Token& token) { return token.spelling == "A"; });
  ASSERT_NE(buffer, tokens.end());
  EXPECT_EQ(buffer->line, 4);
  shaders::CompileRequest request;
  request.file = "m.hlsl";
  request.text = prepared.text;
  EXPECT_FALSE(hlsl::has_errors(shaders::compile(request).diagnostics));
}

TEST(BufferAliases, OfTwoBuffersAreAnError) {
  const std::string head =
      "StructuredBuffer<int> A; StructuredBuffer<int> B; struct S { StructuredBuffer<int> b; }; ";
  expect_error(resolve_buffer_aliases, head + "void f() { S s; s.b = A; S t; t.b = B; }",
               "'b' is an alias of 'A' and of 'B'");
  expect_error(resolve_buffer_aliases,
               head + "void f(int A) { S s; s.b = B; } void g() { S s; s.b = A; s.b = A; }",
               "'b' is an alias of");
  expect_error(resolve_buffer_aliases, head + "void f(int A) { } void g() { S s; s.b = A; }",
               "rename that one");
}

TEST(CbufferResources, StandBeforeTheirCbuffer) {
  expect(move_out_of_cbuffers, "cbuffer C { uint a; static const int b[2] = {3, 4}, c = 4; float d; };",
         "static const int b[2] = {3, 4}, c = 4; cbuffer C { uint a; float d; };");
  expect(move_out_of_cbuffers, "cbuffer C { float a; Texture2D t; SamplerState s; };",
         "Texture2D t; SamplerState s; cbuffer C { float a; };");
  expect(move_out_of_cbuffers, "cbuffer C { Texture2D t; SamplerState s; }; float b;",
         "Texture2D t; SamplerState s; ; float b;");
  expect_untouched(move_out_of_cbuffers, "static int a; struct S { static const int b = 1; };");
}

TEST(Dx9Samplers, DeclarationsBecomeTwo) {
  const auto run = separate_dx9_samplers;
  expect(run, "sampler2D _A, _B[2] : register(s3); float4 x;",
         "Texture2D _A, _B[2] : register(t3); SamplerState sampler_A; SamplerState sampler_B[2] : "
         "register(s3); float4 x;");
  expect(run, "uniform samplerCUBE c : TEXUNIT0; static sampler3D v; SamplerState samplerc;",
         "uniform TextureCube c; uniform SamplerState samplerc_; static Texture3D v; static SamplerState "
         "samplerv;"
         "SamplerState samplerc;");
  expect(run, "sampler2D s = sampler_state { Filter = 1; };", "Texture2D s; SamplerState samplers;");
  expect(run, "struct S { sampler1D m; }; void f(sampler2D, const sampler2D t[2]) { }",
         "struct S { Texture1D m; SamplerState samplerm; };"
         "void f(Texture2D, SamplerState, const Texture2D t[2], const SamplerState samplert[2]) { }");
}

TEST(Dx9Samplers, UsesBecomeTwoAndAreDefinedOnce) {
  expect(separate_dx9_samplers,
         "sampler2D t; void f(float2 t) { g(t); } void h(S s) { g(t, tex2D(t, tex2D(t, 0).xy)); }",
         "float4 tex2D(Texture2D t, SamplerState s, float2 c) { return t.Sample(s, c); }"
         "Texture2D t; SamplerState samplert; void f(float2 t) { g(t); }"
         "void h(S s) { g(t, samplert, tex2D(t, samplert, tex2D(t, samplert, 0).xy)); }");
  expect(separate_dx9_samplers,
         "float4 tex2D(sampler2D s, float3 c) { return 0; } sampler2D t; void f() { tex2D(t, c); }",
         "float4 tex2D(Texture2D s, SamplerState samplers, float3 c) { return 0; } Texture2D t; SamplerState "
         "samplert;"
         "void f() { tex2D(t, samplert, c); }");
}

TEST(Dx9Samplers, PlainSamplersAreWhatReadsThem) {
  expect(separate_dx9_samplers,
         "float4 f(sampler a) { return texCUBElod(a, 0); } sampler s; sampler t; void g() { f(s); "
         "T.Sample(t, 0); }",
         "float4 texCUBElod(TextureCube t, SamplerState s, float4 c) { return t.SampleLevel(s, c.xyz, c.w); }"
         "float4 f(TextureCube a, SamplerState samplera) { return texCUBElod(a, samplera, 0); }"
         "TextureCube s; SamplerState samplers; sampler t; void g() { f(s, samplers); T.Sample(t, 0); }");
  expect_error(separate_dx9_samplers, "sampler s; void f() { tex2D(s, 0); tex3D(s, 0); }",
               "sampler of Texture2D");
  expect_untouched(separate_dx9_samplers, "sampler s; Texture2D t; float4 f() { return t.Sample(s, 0); }");
}

TEST(Dx9Samplers, WhatCannotBeSaidIsAnError) {
  expect_error(separate_dx9_samplers, "sampler2D s; void f() { return s; }",
               "declare a texture and a SamplerState");
  expect_error(separate_dx9_samplers, "sampler2D s; void f() { g(c ? s : 0); }", "nothing else");
}

TEST(Dx9Functions, AreAllOfTheDocumentation) {
  for (const char* dimension : {"1D", "2D", "3D", "CUBE"}) {
    const std::string name = std::string("tex") + dimension;
    for (const char* kind : {"", "bias", "lod", "proj"})
      EXPECT_THAT(dx9_definition(name + kind, 2), HasSubstr("float4 " + name + kind + "(Texture")) << kind;
    for (const char* kind : {"", "grad"})
      EXPECT_THAT(dx9_definition(name + kind, 4), HasSubstr(".SampleGrad("));
    EXPECT_THAT(dx9_definition(name + "lod", 4), IsEmpty());
    EXPECT_THAT(dx9_definition(name + "grad", 2), IsEmpty());
  }
  EXPECT_EQ(dx9_definition("tex3Dproj", 2),
            "float4 tex3Dproj(Texture3D t, SamplerState s, float4 c) { return t.Sample(s, c.xyz / c.w); }");
  EXPECT_EQ(dx9_definition("tex1Dbias", 2),
            "float4 tex1Dbias(Texture1D t, SamplerState s, float4 c) { return t.SampleBias(s, c.x, c.w); }");
  for (const char* name : {"tex", "tex4D", "tex2Dfetch", "texture", "sampler2D"})
    EXPECT_FALSE(dx9_function(name)) << name;
}

TEST(PlainRegisters, SayTheirKindAndSpace) {
  expect(plain_registers, "Texture2D t : register(ps_5_0, t1, space2); sampler s : register(ps, s[3]) ;",
         "Texture2D t : register(t1, space2); sampler s : register(s3);");
  expect(plain_registers, "float4 a : register(c4), b : register(C1.y); int i : register(i0);",
         "float4 a, b; int i;");
  expect(plain_registers, "sampler s : register(vs, s1) : register(ps, s2);", "sampler s : register(s2);");
  expect_untouched(plain_registers, "cbuffer C : register(b1, space1) { float a : packoffset(c1.y); }");
}

TEST(TextureReads, ByComparisonStandAloneWhereTheTextureIsReadOtherwise) {
  const std::string both = "float f(Texture2D t) { return t.Load(0).x + ";
  expect(separate_texture_reads, both + "t.SampleCmpLevelZero(s, uv, z); }",
         "float SampleCmpLevelZero_of(Texture2D t, SamplerComparisonState s, float2 c, float reference)"
         "{ return t.SampleCmpLevelZero(s, c, reference); }" +
             both + "SampleCmpLevelZero_of(t, s, uv, z); }");
  expect_untouched(separate_texture_reads, both + "t.SampleCmpLevelZero(s, uv, z, int2(1, 0)); }");
  expect_untouched(separate_texture_reads, "float f(Texture2D t) { return t.SampleCmp(s, uv, z); }");
  expect_untouched(separate_texture_reads,
                   "Texture2D t; float f() { return t.Load(0).x + t.SampleCmp(s, uv, z); }");
}

TEST(TextureReads, OfMembersOutOfReachStandAlone) {
  const std::string head = "struct S { TextureCubeArray<float2> t; }; S make(); struct O { S in; }; ";
  expect(separate_texture_reads,
         head + "float2 f(S s[2]) { return s[1].t.SampleGrad(p, c, x, y) + make().t.Sample(p, c); }",
         "float2 SampleGrad_of(TextureCubeArray<float2> t, SamplerState s, float4 c, float3 dx, float3 dy)"
         "{ return t.SampleGrad(s, c, dx, dy); }"
         "float2 Sample_of(TextureCubeArray<float2> t, SamplerState s, float4 c) { return t.Sample(s, c); }" +
             head +
             "float2 f(S s[2]) { return SampleGrad_of(s[1].t, p, c, x, y) + Sample_of(make().t, p, c); }");
  expect_untouched(separate_texture_reads,
                   head + "Texture2D a[3]; float4 f(S s) { return s.t.Sample(p, c) + a[1].Sample(p, c); }");
}

TEST(MatrixCasts, OfWholeNumbersGoThroughAFloat) {
  expect(
      widen_matrix_casts,
      "x = (float4x4)0 + (half3x3)-1u + float2x2(true) + (double2x2)0x1F; int k; y = (float3x4)k;",
      "x = (float4x4)(float)0 + (half3x3)(half)-1u + float2x2((float)true) + (double2x2)(double)0x1F; int k;"
      "y = (float3x4)(float)k;");
  expect_untouched(
      widen_matrix_casts,
      "x = (float4x4)0.5 + (float4x4)1e3 + (int2x2)0 + (float4)0 + (float2x2)m + float2x2(1, 0, 0, 1)"
      "+ (float3x3)f(0) + (float5x3)0 + float3x3(m[0]); float4x4 n; int a[2]; y = (float3x3)a[0];");
}

shaders::CompileResult compile_fragment(const std::string& text, bool prepare) {
  shaders::CompileRequest request;
  request.file = "resources.hlsl";
  request.text = text;
  request.stage = hlsl::Stage::fragment;
  request.prepare = prepare;
  return shaders::compile(request);
}

struct Refused {
  const char* what;
  const char* text;
};
// Prints the case by its name.
void PrintTo(const Refused& refused, std::ostream* out) {
  *out << refused.what;
}

class RefusedWithoutTheStage : public testing::TestWithParam<Refused> {};

TEST_P(RefusedWithoutTheStage, IsAcceptedWithIt) {
  const std::string text = std::string("float4 Main(float4 uv : TEXCOORD0) : SV_Target { return f(uv); }\n");
  const std::string all = GetParam().text + ("\n" + text);
  const shaders::CompileResult without = compile_fragment(all, false);
  EXPECT_TRUE(has_errors(without.diagnostics)) << all;
  const shaders::CompileResult with = compile_fragment(all, true);
  EXPECT_FALSE(has_errors(with.diagnostics)) << format(with.diagnostics.at(0));
  EXPECT_FALSE(with.spirv.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Resources, RefusedWithoutTheStage,
    testing::Values(
        Refused{"buffer_in_struct",
                "ByteAddressBuffer B; struct S { ByteAddressBuffer b; };"
                "float4 f(float4 uv) { S s; s.b = B; return asfloat(s.b.Load4(0)); }"},
        Refused{"comparison",
                "Texture2DArray T; SamplerState S; SamplerComparisonState C;"
                "float4 g(Texture2DArray t, float3 c) { return t.Sample(S, c) * t.SampleCmp(C, c, 0.5); }"
                "float4 f(float4 uv) { return g(T, uv.xyz); }"},
        Refused{"nested_texture",
                "Texture1D T; SamplerState S; struct A { Texture1D t; }; struct B { A a; };"
                "float4 f(float4 uv) { B b; b.a.t = T; return b.a.t.SampleBias(S, uv.x, 1); }"},
        Refused{"dx9_2d", "sampler2D T; float4 f(float4 uv) { return tex2D(T, uv) + tex2Dproj(T, uv); }"},
        Refused{"dx9_cube",
                "samplerCUBE T; float4 f(float4 uv) { return texCUBE(T, uv) + texCUBElod(T, uv) +"
                "texCUBEbias(T, uv) + texCUBEgrad(T, uv, 0, 0) + texCUBEproj(T, uv); }"},
        Refused{"dx9_3d",
                "sampler3D T; float4 f(float4 uv) { return tex3D(T, uv) + tex3Dlod(T, uv) +"
                "tex3Dbias(T, uv) + tex3D(T, uv.xyz, 0, 0) + tex3Dproj(T, uv); }"},
        Refused{"dx9_1d",
                "sampler1D T; float4 f(float4 uv) { return tex1D(T, uv.x) + tex1Dlod(T, uv) +"
                "tex1Dbias(T, uv) + tex1Dgrad(T, uv.x, 0, 0) + tex1Dproj(T, uv); }"},
        Refused{"dx9_plain", "sampler T; float4 f(float4 uv) { return tex2Dlod(T, uv); }"},
        Refused{"dx9_precision",
                "sampler2D_float T; half4 g(sampler2D_half t, half2 c) { return tex2D(t, c); }"
                "float4 f(float4 uv) { return g(T, uv.xy); }"},
        Refused{"dx9_array",
                "sampler2D T[2]; float4 f(float4 uv) { return tex2D(T[0], uv) + tex2D(T[1], uv); }"},
        Refused{"register_part", "float a : register(c1.y); float4 f(float4 uv) { return a; }"}),
    [](const auto& tested) { return std::string(tested.param.what); });

// Any order of the words that these passes look for is read without harm, and what is printed is read the
// same again.
TEST(ResourcePasses, AnyTokensAreRead) {
  const std::vector<std::string> words{"struct",    "S",       "{",         "}",
                                       ";",         "(",       ")",         "[",
                                       "]",         ",",       ".",         "=",
                                       "<",         ">",       ":",         "?",
                                       "0",         "2",       "Texture2D", "SamplerState",
                                       "sampler2D", "sampler", "tex2D",     "StructuredBuffer",
                                       "float4",    "cbuffer", "static",    "const",
                                       "a",         "b",       "f",         "register",
                                       "s1",        "return",  "SampleCmp", "(S)0",
                                       "a.b",       "this",    "::"};
  std::mt19937 random(5);
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (std::size_t length = random() % 40; length > 0; --length)
      text += words[random() % words.size()] + " ";
    const std::string once = prepare(text, "m").text;
    EXPECT_EQ(blank_separated(once), blank_separated(TokenText(once, "m").print())) << text;
  }
}

TEST(ResourcePasses, ReadLongTextsInTimeThatGrowsWithThem) {
  std::string text =
      "struct S { Texture2D t; StructuredBuffer<int> b; float a; float get() { return a; } }; sampler2D q;\n";
  for (int i = 0; i < 20000; ++i) {
    const std::string n = std::to_string(i);
    text.append("sampler2D q")
        .append(n)
        .append("; StructuredBuffer<int> B")
        .append(n)
        .append("; float f")
        .append(n);
    text.append("(S s) { sampler2D l = q").append(n).append("; return s.get() + tex2D(l, 0).x + (S)0; }\n");
  }
  EXPECT_LT(processor_seconds([&] { prepare(text, "m"); }), 20.0);
}

}  // namespace
}  // namespace penumbra::preparation
