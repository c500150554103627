// Declarations and writes that HLSL refuses and glslang takes without a word.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "preparation/prepare.h"

namespace penumbra::preparation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> refused(const std::string& text, const EntryPoint& entry) {
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& note : prepare(text, "a", entry).notes)
    if (note.severity == hlsl::Severity::error)
      all.push_back(std::to_string(note.line) + ": " + note.message);
  return all;
}

std::vector<std::string> refused(const std::string& text, bool dxc = false) {
  return refused(text, {"Frag", hlsl::Stage::fragment, dxc});
}

std::vector<std::string> refused_in(const std::string& body) {
  return refused(
      "struct S { float xx; };\nfloat4 Frag(float4 c : COLOR) : SV_Target { float3 v; float4x4 m; S s;\n" +
      body + "\nreturn 1; }");
}

TEST(ResourceMethods, AreThoseOfTheType) {
  const auto refused_read = [](const std::string& read) {
    return refused(
        "Texture2D t; SamplerState p; sampler2D d; Texture2DMS<float4, 4> m;\nByteAddressBuffer b; "
        "RWTexture2D<float4> w; struct S { Texture2D t; };\nfloat4 Frag(float2 uv : TEXCOORD0) : "
        "SV_Target {\nS s; s.t = t; " +
        read + " return 1; }");
  };
  EXPECT_THAT(refused_read("tex2D(t, uv);"),
              ElementsAre("4: 'tex2D' takes a sampler2D, and 't' is a Texture2D: write t.Sample() with a "
                          "SamplerState"));
  EXPECT_THAT(refused_read("tex2Dlod(s.t, uv.xyxy);"), ElementsAre(HasSubstr("'s.t' is a Texture2D")));
  EXPECT_THAT(refused_read("d.Sample(p, uv);"),
              ElementsAre("4: a sampler2D has no method 'Sample': sample it with tex2D()"));
  EXPECT_THAT(refused_read("p.Sample(p, uv);"),
              ElementsAre("4: a SamplerState has no method 'Sample': call it on the texture"));
  EXPECT_THAT(refused_read("float f = b.Load<float>(0);"),
              ElementsAre(HasSubstr("4: 'Load' takes no type in '<>'")));
  EXPECT_THAT(refused_read("float4 c = m.sample[1][uint2(uv)];"),
              ElementsAre("4: '.sample[][]' is not supported: write m.Load(texel, sample)"));
  EXPECT_THAT(refused_read("w.Store(uint2(uv), 1);"),
              ElementsAre("4: a RWTexture2D has no method 'Store': write w[texel] = value"));
  EXPECT_THAT(refused_read("t.Sample(p, uv); tex2D(d, uv); b.Load(0); m.Load(uv, 1); w[uint2(uv)] = 1;"),
              IsEmpty());
  EXPECT_THAT(refused("Texture2D t;\nfloat4 tex2D(Texture2D t, float2 uv) { return t.Load(int3(uv, 0)); }\n"
                      "float4 Frag(float2 uv : TEXCOORD0) : SV_Target { return tex2D(t, uv); }"),
              IsEmpty());
}

TEST(StructMembers, AreNotStatic) {
  EXPECT_THAT(
      refused("struct S { static const float k = 2; float a; };"),
      ElementsAre("1: 'k' is a static member, which is not supported: declare it outside of the structure"));
}

// Otherwise it would crash: the text goes to glslang in search of further errors.
TEST(ClipDistances, ThatAreUnsupportedAreKeptFromTheCompiler) {
  EXPECT_THAT(
      prepare("[maxvertexcount(1)] void Main(point float c[1] : SV_ClipDistance0, inout PointStream<V> s) {}",
              "a", EntryPoint{"Main", hlsl::Stage::geometry})
          .text,
      Not(HasSubstr(": SV_ClipDistance0")));
}

TEST(ClipDistances, AreNotReadInGeometryPrograms) {
  const auto refused_main = [](const std::string& text, hlsl::Stage stage) {
    return refused(text, {"Main", stage, false});
  };
  const std::string vertex = "struct V { float4 p : SV_Position; float c : SV_ClipDistance0; };\n";
  EXPECT_THAT(
      refused_main(vertex + "[maxvertexcount(3)] void Main(triangle V i[3], inout TriangleStream<V> s) {}",
                   hlsl::Stage::geometry),
      ElementsAre(HasSubstr("1: 'SV_ClipDistance0' cannot be read in a geometry program here: pass")));
  EXPECT_THAT(
      refused_main(vertex + "struct I { float4 p : SV_Position; };\n[maxvertexcount(3)] void Main(triangle I "
                            "i[3], inout TriangleStream<V> s) {}",
                   hlsl::Stage::geometry),
      IsEmpty());
  EXPECT_THAT(
      refused_main(vertex + "[domain(\"tri\")] V Main(float3 b : SV_DomainLocation) { V v; return v; }",
                   hlsl::Stage::domain),
      ElementsAre("1: 'SV_ClipDistance0' is not supported in a domain program"));
  EXPECT_THAT(refused_main(vertex + "V Main(float4 p : POSITION) { V v; v.p = p; v.c = 1; return v; }",
                           hlsl::Stage::vertex),
              IsEmpty());
}

TEST(StructMembers, AreDeclaredOnce) {
  EXPECT_THAT(refused("struct S { float a; };\nstruct T { float a;\nhalf b, a; };"),
              ElementsAre("3: 'a' is already declared, at a:2: remove one of the two"));
}

TEST(WrittenComponents, AreNamedOnce) {
  EXPECT_THAT(refused_in("c.xx = c.xy;"),
              ElementsAre("3: '.xx' has x twice, and cannot be written: name each component once"));
  EXPECT_THAT(refused_in("v.xyx = 1;\nv.gg += 2;\nv.xx++;\n--v.zz;\nm._m00_m00 = 1;\nm._11_11 = 1;"),
              ElementsAre(HasSubstr("3: "), HasSubstr("4: "), HasSubstr("5: "), HasSubstr("6: "),
                          HasSubstr("7: '._m00_m00' has _m00 twice"), HasSubstr("8: ")));
  EXPECT_THAT(refused_in("(c.xx) = 1;\n((v.yy)) += 1;"), ElementsAre(HasSubstr("3: "), HasSubstr("4: ")));
  EXPECT_THAT(refused_in("if (any(c.xx)) ++v.x; (v.xy) = (c.xx); while (c.xx == 1) --v.y;"), IsEmpty());
  EXPECT_THAT(refused_in("v.xy = c.xx; m._m00_m01 = c.yy; s.xx = 1; bool b = any(c.xx == 1); v = c.xxx;"),
              IsEmpty());
}

TEST(MatrixComponents, AreCountedInOneWay) {
  EXPECT_THAT(
      refused_in("c = m._m00_m11;\nv.xy = m._m00_11;\nm._12_m01 = 1;"),
      ElementsAre("4: '._m00_11' mixes zero-based and one-based subscripts: write _m00 or _11 throughout",
                  HasSubstr("5: '._12_m01' mixes")));
}

TEST(Registers, AreOfTheTypesClassAndExist) {
  EXPECT_THAT(refused("Texture2D t : register(s0);"),
              ElementsAre("1: register 's0' is not one for a Texture2D, whose registers begin with 't'"));
  EXPECT_THAT(refused("RWTexture2D<float4> t : register(t3);"), ElementsAre(HasSubstr("begin with 'u'")));
  EXPECT_THAT(refused("cbuffer C : register(t1) { float a; };"), ElementsAre(HasSubstr("begin with 'b'")));
  EXPECT_THAT(refused("cbuffer C : register(b20) { float a; };"),
              ElementsAre("1: register 'b20' does not exist in Direct3D 11, which has b0 to b13"));
  EXPECT_THAT(refused("SamplerState s : register(s16);"), ElementsAre(HasSubstr("s0 to s15")));
  EXPECT_THAT(refused("Texture2D t : register(q1);"), ElementsAre(HasSubstr("'q1' does not exist")));
  EXPECT_THAT(refused("cbuffer C : register(b20) { float a; }; Texture2D t : register(t300, space1);", true),
              IsEmpty());
  EXPECT_THAT(refused("cbuffer C : register(b13) { float a; }; Texture2D t : register(t0, space1);\n"
                      "SamplerState s : register(ps_5_0, s[2]); sampler2D d : register(s1); float4 k : "
                      "register(c4); RWStructuredBuffer<float> u : register(u7); ByteAddressBuffer b : "
                      "register(T3); static float x = 1; tbuffer B : register(t4) { float z; };"),
              IsEmpty());
}

TEST(PackOffsets, AreInACbufferAndInOneRegister) {
  const auto of = [](const std::string& members) { return refused("cbuffer C {\n" + members + " };"); };
  EXPECT_THAT(of("float2 a : packoffset(c0.w);"),
              ElementsAre("2: the packoffset of 'a' leaves room for 1 of its 2 components in its register, "
                          "and a vector must not straddle two: begin at an earlier component"));
  EXPECT_THAT(of("float4x4 m : packoffset(c0.y);"),
              ElementsAre(HasSubstr("not the beginning of a register")));
  EXPECT_THAT(of("float a[2] : packoffset(c0.z);"),
              ElementsAre(HasSubstr("not the beginning of a register")));
  EXPECT_THAT(of("float2 a : packoffset(c0.z); float b : packoffset(c0.y); float4x4 m : packoffset(c1); "
                 "float a2[2] : packoffset(c5.x);"),
              IsEmpty());
  EXPECT_THAT(refused("float4 k : packoffset(c0);"), ElementsAre(HasSubstr("1: packoffset is for members")));
}

TEST(Arrays, HaveASize) {
  EXPECT_THAT(refused("float a[];"),
              ElementsAre("1: the array 'a' has no size: write how many elements it has"));
  EXPECT_THAT(refused("groupshared float a[];"), ElementsAre(HasSubstr("has no size")));
  EXPECT_THAT(refused("struct S { float a[]; };"), ElementsAre(HasSubstr("has no size")));
  EXPECT_THAT(refused_in("float a[];"), ElementsAre(HasSubstr("3: the array 'a' has no size")));
  EXPECT_THAT(refused_in("float a[-2], b[0];"),
              ElementsAre("3: the array 'a' has a negative size",
                          "3: the array 'b' has 0 elements: it needs at least one"));
  EXPECT_THAT(
      refused_in("int v[2], i; for (i = 0; i < 2 && (bool)(i > v[0]); ++i) {} while (i < 2 > v[0]) {}"),
      IsEmpty())
      << "two comparisons, no declaration of an array of no elements";
  for (const char* large : {"65537", "0x10001", "70000u", "99999999999999999999"})
    EXPECT_THAT(
        refused("static float a[2][" + std::string(large) + "];"),
        ElementsAre(
            "1: the array 'a' has more than 65536 elements in one dimension: use a buffer or a texture"))
        << large;
  EXPECT_THAT(refused("static float a[65536][0x10000];"), IsEmpty());
  EXPECT_THAT(refused("static float a[65537];", true), IsEmpty());
  EXPECT_THAT(refused("Texture2D t[] : register(t0, space1);"), ElementsAre(HasSubstr("has no size")));
  EXPECT_THAT(refused("Texture2D t[] : register(t0, space1);", true), IsEmpty());
  EXPECT_THAT(refused("static const float a[] = { 1, 2 }; static const int N = 3; float b[N - 1][2];"),
              IsEmpty());
}

TEST(StatementAttributes, OfFxcAloneAreTakenOut) {
  const std::string text =
      prepare(
          "[maxtessfactor(8.0)] float f(int n) { int call = 0, a[2]; [fastopt] [unroll] for (;;) { } "
          "[allow_uav_condition] while (n) { } "
          "[forcecase] switch (n) { default: break; } [call] switch (n) { default: "
          "break; } return a[call]; }",
          "a", EntryPoint{"Frag"})
          .text;
  for (const char* gone : {"maxtessfactor", "fastopt", "allow_uav_condition", "forcecase", "[call] switch"})
    EXPECT_EQ(text.find(gone), std::string::npos) << gone;
  EXPECT_NE(text.find("unroll"), std::string::npos);
  EXPECT_NE(text.find("return a[call]"), std::string::npos) << text;
}

TEST(Semantics, AreOneOfEightTargets) {
  EXPECT_THAT(refused("float4 Frag() : SV_Target8 { return 1; }"),
              ElementsAre("1: 'SV_Target8' does not exist: the targets are SV_Target0 to SV_Target7"));
  EXPECT_THAT(refused("float4 Frag() : SV_Target : SV_Target1 { return 1; }"),
              ElementsAre("1: 'Frag' has two semantics, 'SV_Target' and 'SV_Target1': write one of them"));
  EXPECT_THAT(refused("float4 Frag(float2 a : A, float4 b : B : register(c1)) : SV_Target7 { return 1; }"),
              IsEmpty());
}

TEST(Semantics, OfSystemValuesAreOfTheirType) {
  const auto vertex = [](const std::string& inputs) {
    return refused("float4 Frag(float4 p : POSITION, " + inputs + ") : SV_Position { return p; }",
                   EntryPoint{"Frag", hlsl::Stage::vertex});
  };
  EXPECT_THAT(vertex("float id : SV_VertexID"),
              ElementsAre("1: 'SV_VertexID' is an integer: declare it as uint"));
  EXPECT_THAT(vertex("uint2 id : SV_InstanceID"), ElementsAre(HasSubstr("'SV_InstanceID' is an integer")));
  EXPECT_THAT(vertex("int a : SV_VertexID, min16uint b : sv_instanceid"), IsEmpty());
  EXPECT_THAT(refused("float4 Frag(float face : SV_IsFrontFace) : SV_Target { return face; }"),
              ElementsAre("1: 'SV_IsFrontFace' is a bool: declare it as one"));
  EXPECT_THAT(refused("float4 Frag(bool face : SV_IsFrontFace, half4 p : VPOS) : SV_Target { return p; }"),
              IsEmpty());
  const auto compute = [](const std::string& input) {
    return refused("[numthreads(1, 1, 1)] void Frag(" + input + ") {}",
                   EntryPoint{"Frag", hlsl::Stage::compute});
  };
  EXPECT_THAT(
      compute("uint4 id : SV_DispatchThreadID"),
      ElementsAre("1: 'SV_DispatchThreadID' is a vector of three integers: declare it as uint3, uint2 or "
                  "uint"));
  EXPECT_THAT(compute("float3 id : SV_GroupID"), ElementsAre(HasSubstr("'SV_GroupID' is a vector of three")));
  EXPECT_THAT(compute("uint2 a : SV_GroupThreadID, int3 b : SV_GroupID, uint c : SV_GroupIndex"), IsEmpty());
}

}  // namespace
}  // namespace penumbra::preparation
