// Tests declarations and writes that HLSL refuses and glslang takes without a word.
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

// Otherwise the compiler would crash: the text goes to glslang in search of further errors.
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

TEST(ResourceMethods, MayHaveNothingBeforeTheirDot) {
  EXPECT_THAT(refused(".a"), IsEmpty()) << "the front end reports it";
}

TEST(ResourceMethods, OfBuffersThatGrowOrShrinkAreTheirOwn) {
  const auto of = [](const std::string& body) {
    return refused(
        "AppendStructuredBuffer<float> a; ConsumeStructuredBuffer<float> c; RWStructuredBuffer<float> w;\n"
        "float4 Frag() : SV_Target { " +
        body + " return 1; }");
  };
  EXPECT_THAT(of("a[0] = 1;"),
              ElementsAre("2: 'a' is an AppendStructuredBuffer, which has Append() and no []: for "
                          "elements by number declare a StructuredBuffer or RWStructuredBuffer"));
  EXPECT_THAT(of("float f = c[1];"),
              ElementsAre(HasSubstr("'c' is a ConsumeStructuredBuffer, which has Consume()")));
  EXPECT_THAT(
      of("float f = a.Consume();"),
      ElementsAre(
          "2: AppendStructuredBuffer has no method 'Consume': it belongs to ConsumeStructuredBuffer"));
  EXPECT_THAT(of("w.Append(1);"), ElementsAre(HasSubstr("RWStructuredBuffer has no method 'Append'")));
  EXPECT_THAT(of("a.Append(c.Consume()); w[0] = w[1];"), IsEmpty());
}

TEST(ResourceArguments, AreNoNumbers) {
  const auto of = [](const std::string& value) {
    return refused(
        "Texture2D T; SamplerState P; float4 C; Texture2D A[2];\nfloat4 Frag(float2 uv : TEXCOORD0) : "
        "SV_Target "
        "{ return " +
        value + "; }");
  };
  const std::string texture = " is a Texture2D, and max() takes numbers: read it with Sample or Load";
  EXPECT_THAT(of("max(T, C)"), ElementsAre("2: 'T'" + texture));
  EXPECT_THAT(of("max(C, A[1])"), ElementsAre("2: 'A[1]'" + texture));
  EXPECT_THAT(of("lerp(C, T, .5)"), ElementsAre(HasSubstr("lerp() takes numbers")));
  EXPECT_THAT(of("dot(P, C)"), ElementsAre("2: 'P' is a SamplerState, and dot() takes numbers"));
  EXPECT_THAT(of("max(T.Sample(P, uv), A[1].Load(int3(0, 0, 0)))"), IsEmpty());
  EXPECT_THAT(refused("Texture2D T; float4 max(Texture2D a, int b) { return a.Load(int3(b, 0, 0)); }\n"
                      "float4 Frag() : SV_Target { return max(T, 1); }"),
              IsEmpty());
}

TEST(Returns, HaveTheValueOfTheirFunction) {
  EXPECT_THAT(refused("float4 Frag(float2 uv : TEXCOORD0) : SV_Target {\nif (uv.x > 0) return;\nreturn 1; }"),
              ElementsAre("2: 'Frag' returns a float4: this return needs a value (X3080)"));
  EXPECT_THAT(refused("void F(float a) { if (a > 0) return; } float4 Frag() : SV_Target { F(1); return 1; }"),
              IsEmpty());
}

TEST(Structs, HaveNoConstructors) {
  const std::string type = "struct S { float a, b; }; ";
  EXPECT_THAT(
      refused(type + "float4 Frag() : SV_Target {\nS s = S(1, 2); return s.a; }"),
      ElementsAre("2: HLSL has no constructors of structs: write S value = {...}; or assign the members of a "
                  "'S' one by one"));
  EXPECT_THAT(
      refused(type + "S Make(S s) { return s; } float4 Frag() : SV_Target { S s = (S)0; S t = Make((S)(0)); "
                     "return s.a + t.b; }"),
      IsEmpty());
}

TEST(Casts, DoNotMakeVectorsAndMatricesLarger) {
  const auto cast = [](const std::string& value) {
    return refused("float3x3 m; float2 v; float s;\nfloat4 Frag() : SV_Target { return " + value + "; }");
  };
  EXPECT_THAT(cast("((float4x4)m)[3]"),
              ElementsAre("2: cannot convert from 'float3x3' to 'float4x4', which is larger (X3017): write a "
                          "constructor with all numbers"));
  EXPECT_THAT(cast("(float4)v"), ElementsAre(HasSubstr("from 'float2' to 'float4'")));
  EXPECT_THAT(cast("(float4)s + ((float2x2)m)[0].xyxy + (float4)v.x + (float4)((float2)v).x"), IsEmpty());
}

TEST(Structs, EndWithASemicolon) {
  EXPECT_THAT(
      refused("struct S { float a;\n}\nfloat F() { return 1; } float4 Frag() : SV_Target { return F(); }"),
      testing::Contains("2: expected ';' behind this '}' of a struct"));
  EXPECT_THAT(
      refused("struct S { float a; struct { int b; } c; } s; float4 Frag() : SV_Target { return s.a; }"),
      IsEmpty());
}

TEST(GroupsharedVariables, AreDeclaredOutsideOfFunctions) {
  EXPECT_THAT(
      refused("float4 Frag() : SV_Target {\ngroupshared float s[8]; return 1; }"),
      ElementsAre("2: 's' is groupshared, and such variables belong outside of functions and structs"));
  EXPECT_THAT(refused("groupshared float s[8]; float4 Frag() : SV_Target { return 1; }"), IsEmpty());
}

TEST(CaseLabels, BelongInASwitch) {
  EXPECT_THAT(refused_in("case 1: v.x = 1;"),
              ElementsAre("3: 'case' is in no switch: a label belongs in a switch's braces"));
  EXPECT_THAT(refused_in("if (c.x > 0) { default: v.x = 1; }"),
              ElementsAre(HasSubstr("3: 'default' is in no switch")));
  EXPECT_THAT(refused_in("switch ((int)c.x) { case 1: { v.x = 1; break; } default: break; }"), IsEmpty());
}

TEST(Intrinsics, ThatTheCompilerLacksAreNamed) {
  EXPECT_THAT(
      refused_in("uint4 q = msad4(1, uint2(2, 3), uint4(1, 2, 3, 4));"),
      ElementsAre("3: 'msad4' is HLSL, but is not supported: write out the sums of absolute differences"));
  EXPECT_THAT(refused_in("v.x = GetRenderTargetSampleCount();"),
              ElementsAre(HasSubstr("pass the number in a constant")));
  EXPECT_THAT(refused("uint msad4(uint a) { return a; } float4 Frag() : SV_Target { return msad4(1); }"),
              IsEmpty());
}

TEST(StageAttributes, AreThoseThatTheStageNeeds) {
  const std::string types = "struct V { float4 p : SV_Position; float2 uv : TEXCOORD0; };\n";
  const auto geometry = [&](const std::string& attribute, const std::string& stream) {
    return refused(types + attribute + " void Geom(triangle V i[3], " + stream + " s) { s.Append(i[0]); }",
                   {"Geom", hlsl::Stage::geometry});
  };
  EXPECT_THAT(geometry("[maxvertexcount(3)]", "inout TriangleStream<V>"), IsEmpty());
  EXPECT_THAT(geometry("", "inout TriangleStream<V>"),
              ElementsAre("2: 'Geom' has no [maxvertexcount(n)], which a geometry program needs"));
  EXPECT_THAT(
      geometry("[maxvertexcount(3)]", "TriangleStream<V>"),
      ElementsAre("2: a TriangleStream is changed by what is appended to it: write inout TriangleStream"));
  EXPECT_THAT(geometry("[maxvertexcount(170)]", "inout TriangleStream<V>"), IsEmpty());
  EXPECT_THAT(
      geometry("[maxvertexcount(171)]", "inout TriangleStream<V>"),
      ElementsAre(
          "2: 171 vertices of 6 numbers are 1026, and a geometry program emits at most 1024 (X4552): at "
          "most 170 vertices"));
  const auto hull = [&](const std::string& attributes) {
    return refused(types +
                       "struct F { float e[3] : SV_TessFactor; float i : SV_InsideTessFactor; };\n"
                       "F Patch(InputPatch<V, 3> p) { return (F)0; }\n" +
                       attributes +
                       "V Hull(InputPatch<V, 3> p, uint i : SV_OutputControlPointID) { return p[i]; }",
                   {"Hull", hlsl::Stage::hull});
  };
  const std::string rest =
      "[domain(\"tri\")] [partitioning(\"integer\")] [outputtopology(\"triangle_cw\")] "
      "[outputcontrolpoints(3)] ";
  EXPECT_THAT(hull(rest + "[patchconstantfunc(\"Patch\")] "), IsEmpty());
  EXPECT_THAT(hull(rest), ElementsAre(HasSubstr("4: 'Hull' has no [patchconstantfunc(\"Name\")]")));
  EXPECT_THAT(hull(rest + "[patchconstantfunc(\"Pach\")] "),
              ElementsAre("4: [patchconstantfunc] names 'Pach', and there is no such function"));
}

TEST(ThreadGroups, HaveThreeSizes) {
  const auto kernel = [](const std::string& attribute) {
    return refused("RWBuffer<float> r;\n" + attribute + " void K() { r[0] = 1; }",
                   {"K", hlsl::Stage::compute});
  };
  EXPECT_THAT(kernel("[numthreads(8, 8)]"),
              ElementsAre("2: [numthreads(x, y, z)] has three sizes, and 2 are given: write "
                          "1 for those that are not used"));
  EXPECT_THAT(kernel("[numthreads(8, 8, 1)]"), IsEmpty());
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
