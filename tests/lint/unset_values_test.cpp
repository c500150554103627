// Tests the rules output-not-set and read-before-set: what is caught, with its place, and what must not be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lint/linted_shader.h"

namespace penumbra::lint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> outputs(const std::string& text, hlsl::Stage stage = hlsl::Stage::fragment) {
  return findings_of("output-not-set", text, stage);
}
std::vector<std::string> reads(const std::string& text, hlsl::Stage stage = hlsl::Stage::fragment) {
  return findings_of("read-before-set", text, stage);
}

TEST(OutputNotSet, AFunctionThatReturnsNothingOnSomePath) {
  EXPECT_THAT(outputs(fragment("", "F(uv.x)", "float F(float a)\n{\n    if (a > 0.5) return 1;\n}\n")),
              ElementsAre("1:7 error output-not-set: not every path through 'F' returns a value"));
}

TEST(OutputNotSet, EveryPathReturns) {
  EXPECT_THAT(outputs(fragment("", "F(uv.x) + G(flat) + H(flat)",
                               "float F(float a) { if (a > 0.5) return 1; else return 2; }\n"
                               "float G(int k) { switch (k) { case 0: return 1; default: return 2; } }\n"
                               "float H(int k) { while (true) { if (k > 3) return k; k++; } }\n")),
              IsEmpty());
}

TEST(OutputNotSet, AnOutParameterThatIsNeverSetIsAnError) {
  const std::string text = fragment("    float b;\n    F(uv.x, b);\n", "b",
                                    "void F(float a,\n       out float b)\n{\n    a += 1;\n}\n");
  EXPECT_THAT(reads(text), IsEmpty()) << "one cause, one finding";
  EXPECT_THAT(outputs(text),
              ElementsAre("2:18 error output-not-set: out parameter 'b' of 'F' is not set on every path"));
}

TEST(OutputNotSet, AnOutParameterSetOnSomePathsIsAWarning) {
  EXPECT_THAT(
      outputs(fragment("    float2 b;\n    F(uv.x, b);\n", "b.xyxy",
                       "void F(float a, out float2 b)\n{\n    b.x = 0;\n    if (a > 0) b.y = 1;\n}\n")),
      ElementsAre("1:28 warning output-not-set: out parameter 'b.y' of 'F' is not set on every path"));
}

TEST(OutputNotSet, MembersOfAnOutStructAreNamed) {
  EXPECT_THAT(
      outputs(fragment("    S s;\n    F(uv.x, s);\n", "s.a.xxxx",
                       "struct S { float2 a; float b; float c[2]; };\n"
                       "void F(float a, out S s)\n{\n    s.a = a;\n    s.c[1] = 0;\n}\n")),
      ElementsAre("2:23 error output-not-set: out parameter 's.b', 's.c[0]' of 'F' is not set on every "
                  "path"));
}

TEST(OutputNotSet, WhatACalleeSetsIsSet) {
  EXPECT_THAT(outputs(fragment("    S s;\n    Outer(uv.x, s);\n", "s.b",
                               "struct S { float a; float b; };\n"
                               "void Inner(float x, out float b) { b = x; }\n"
                               "void Outer(float x, out S s)\n{\n    s.a = x;\n    Inner(x, s.b);\n}\n")),
              IsEmpty());
}

TEST(OutputNotSet, InoutIsTheCallersAffair) {
  const std::string text =
      fragment("    float b = 1;\n    F(b);\n", "b", "void F(inout float b) { if (b > 2) b = 1; }\n");
  EXPECT_THAT(outputs(text), IsEmpty());
  EXPECT_THAT(reads(text), IsEmpty());
}

TEST(OutputNotSet, ADiscardedPixelOwesNothing) {
  EXPECT_THAT(
      outputs(fragment("", "F(uv.x)", "float F(float a) { if (a > 0.5) return 1; discard; return 0; }\n")),
      IsEmpty());
}

constexpr const char* varyings =
    "struct Varyings\n{\n    float4 position : SV_Position;\n    float2 uv : TEXCOORD0;\n"
    "    float fog : TEXCOORD1;\n};\n";

TEST(OutputNotSet, AStageOutputIsAWarningThatNamesTheMembers) {
  EXPECT_THAT(
      outputs(varyings + std::string("Varyings Main(float3 p : POSITION)\n{\n    Varyings o;\n"
                                     "    o.position = p.xyzz;\n    o.uv.x = p.x;\n    return o;\n}\n"),
              hlsl::Stage::vertex),
      ElementsAre("12:5 warning output-not-set: output 'uv.y', 'fog' of 'Main' is not set on every path"));
}

TEST(OutputNotSet, AStructSetToZeroFirst) {
  EXPECT_THAT(
      outputs(varyings + std::string("Varyings Main(float3 p : POSITION)\n{\n    Varyings o = (Varyings)0;\n"
                                     "    o.position = p.xyzz;\n    return o;\n}\n"),
              hlsl::Stage::vertex),
      IsEmpty());
}

TEST(OutputNotSet, AHelpersResultMattersWhereItLeavesTheStage) {
  const std::string helper = varyings + std::string(
                                            "Varyings Half(float3 p)\n{\n    Varyings o;\n"
                                            "    o.position = p.xyzz;\n    o.uv = p.xy;\n    return o;\n}\n");
  EXPECT_THAT(
      outputs(helper + "Varyings Main(float3 p : POSITION)\n{\n    Varyings o = Half(p);\n    o.fog = 1;\n"
                       "    return o;\n}\n",
              hlsl::Stage::vertex),
      IsEmpty());
  EXPECT_THAT(outputs(helper + "Varyings Main(float3 p : POSITION)\n{\n    return Half(p);\n}\n",
                      hlsl::Stage::vertex),
              ElementsAre("16:5 warning output-not-set: output 'fog' of 'Main' is not set on every path"));
  EXPECT_THAT(
      outputs("struct O { float4 p : SV_Position; };\nO F() { O o; return o; }\nO Main(float3 p : POSITION)\n"
              "{\n    return F();\n}\n",
              hlsl::Stage::vertex),
      ElementsAre("5:5 warning output-not-set: what 'Main' returns is not set on every path"));
}

TEST(ReadBeforeSet, AVariableNeverSet) {
  EXPECT_THAT(reads(fragment("    float a;\n", "uv.xyxy + a")),
              ElementsAre("4:22 warning read-before-set: 'a' is read but never set"));
}

TEST(ReadBeforeSet, AVariableSetOnOneWayOnly) {
  EXPECT_THAT(reads(fragment("    float a;\n    if (uv.x > 0.5) a = 1;\n", "a.xxxx")),
              ElementsAre("5:12 warning read-before-set: 'a' is read before it is set on every path"));
  EXPECT_THAT(reads(fragment("    float a;\n    if (uv.x > 0.5) a = 1; else a = 2;\n", "a.xxxx")), IsEmpty());
}

TEST(ReadBeforeSet, OnlyTheComponentsThatAreUsedCount) {
  EXPECT_THAT(reads(fragment("    float4 v;\n    v.xy = uv;\n", "v.xyyx")), IsEmpty());
  EXPECT_THAT(reads(fragment("    float4 v;\n    v.xy = uv;\n", "v.xyzx")),
              ElementsAre("5:12 warning read-before-set: 'v.z' is read but never set"));
  EXPECT_THAT(reads(fragment("    float4 v;\n    v.xy = uv;\n", "v * 2")),
              ElementsAre("5:12 warning read-before-set: 'v.z', 'v.w' is read but never set"));
}

TEST(ReadBeforeSet, ALoopThatSurelyRunsSetsWhatItSets) {
  EXPECT_THAT(reads(fragment("    float a;\n    for (int i = 0; i < 4; ++i) a = i;\n", "a.xxxx")), IsEmpty());
  EXPECT_THAT(reads(fragment("    float a;\n    float4 c = float4(uv, -1, 1);\n"
                             "    while (c.z < 7 && c.w > 0.9) { c.z += 1; a = c.z; c.w = uv.x; }\n",
                             "a.xxxx")),
              IsEmpty());
  EXPECT_THAT(reads(fragment("    float a;\n    do { a = uv.x; } while (a > 2);\n", "a.xxxx")), IsEmpty());
}

TEST(ReadBeforeSet, ALoopThatMayNotRunDoesNot) {
  EXPECT_THAT(reads(fragment("    float a;\n    for (int i = 0; i < flat; ++i) a = i;\n", "a.xxxx")),
              ElementsAre("5:12 warning read-before-set: 'a' is read before it is set on every path"));
  EXPECT_THAT(reads(fragment("    float a;\n    int n = 4;\n    n -= flat;\n"
                             "    for (int i = 0; i < n; ++i) a = i;\n",
                             "a.xxxx")),
              testing::SizeIs(1));
}

TEST(ReadBeforeSet, AnArrayFilledByIndex) {
  EXPECT_THAT(
      reads(fragment("    float a[4];\n    for (int i = 0; i < 4; ++i) a[i] = i;\n", "a[flat].xxxx + a[2]")),
      IsEmpty());
  EXPECT_THAT(reads(fragment("    float a[4];\n    a[0] = 1;\n", "a[2].xxxx")),
              ElementsAre("5:12 warning read-before-set: 'a[2]' is read but never set"));
}

constexpr const char* surface =
    "struct Surface { float3 albedo; float alpha; };\n"
    "float Opaque(Surface s) { return s.albedo.x; }\n"
    "float Blended(Surface s) { return s.albedo.x * s.alpha; }\n"
    "float Through(Surface s) { return Blended(s); }\n";

TEST(ReadBeforeSet, AStructPartlySetMayGoWhereTheRestIsNotRead) {
  EXPECT_THAT(reads(fragment("    Surface s;\n    s.albedo = 1;\n", "Opaque(s)", surface)), IsEmpty());
}

TEST(ReadBeforeSet, AStructPartlySetIsCaughtWhereACalleeReadsTheRest) {
  EXPECT_THAT(
      reads(fragment("    Surface s;\n    s.albedo = 1;\n", "Blended(s)", surface)),
      ElementsAre("9:20 warning read-before-set: 's.alpha' is passed to 'Blended', which reads it, but "
                  "never set"));
  EXPECT_THAT(
      reads(fragment("    Surface s;\n    s.albedo = 1;\n", "Through(s)", surface)),
      ElementsAre("9:20 warning read-before-set: 's.alpha' is passed to 'Through', which reads it, but "
                  "never set"));
}

TEST(ReadBeforeSet, AMemberThatACalleeGotToChangeIsStillTheCallers) {
  const std::string before = std::string(surface) +
                             "void Maybe(inout float a, float b) { if (b > 2) a = b; }\n"
                             "float Outer(Surface s) { Maybe(s.alpha, s.albedo.x); return s.alpha; }\n";
  EXPECT_THAT(
      reads(fragment("    Surface s;\n    s.albedo = 1;\n", "Outer(s)", before)),
      ElementsAre("11:18 warning read-before-set: 's.alpha' is passed to 'Outer', which reads it, but never "
                  "set"));
}

TEST(ReadBeforeSet, CopiesOfStructsCarryWhatIsUnset) {
  EXPECT_THAT(
      reads(fragment("    Surface s;\n    s.albedo = 1;\n    Surface t = s;\n", "t.albedo.xyzx", surface)),
      IsEmpty());
  EXPECT_THAT(reads(fragment("    Surface s;\n    s.albedo = 1;\n    Surface t = s;\n", "t.alpha", surface)),
              ElementsAre("10:14 warning read-before-set: 't.alpha' is read before it is set on every path"));
}

TEST(ReadBeforeSet, ReturnedStructsCarryItToo) {
  const std::string make = std::string(surface) + "Surface Make() { Surface s; s.alpha = 1; return s; }\n";
  EXPECT_THAT(reads(fragment("", "Make().alpha", make)), IsEmpty());
  EXPECT_THAT(
      reads(fragment("", "Make().albedo.xyzz", make)),
      ElementsAre("8:19 warning read-before-set: 'albedo' of what 'Make' returns is read, but not set on "
                  "every path"));
}

TEST(ReadBeforeSet, InoutThatIsOnlyWritten) {
  const std::string before = "void Set(inout float a) { a = 1; }\nvoid Add(inout float a) { a += 1; }\n";
  EXPECT_THAT(reads(fragment("    float a;\n    Set(a);\n", "a", before)), IsEmpty());
  EXPECT_THAT(
      reads(fragment("    float a;\n    Add(a);\n", "a", before)),
      ElementsAre("6:9 warning read-before-set: 'a' is passed to 'Add', which reads it, before it is set "
                  "on every path"));
}

TEST(ReadBeforeSet, AnOutParameterReadBeforeItIsSet) {
  EXPECT_THAT(
      reads(fragment("    float b = 1;\n    F(b);\n", "b", "void F(out float b)\n{\n    b = b + 1;\n}\n")),
      ElementsAre("3 warning read-before-set: 'b' is read before it is set on every path"));
}

TEST(ReadBeforeSet, StreamsOfAGeometryShader) {
  const std::string before = "struct V { float4 p : SV_Position; float2 uv : TEXCOORD0; };\n";
  const auto shader = [&](const std::string& set) {
    return before +
           "[maxvertexcount(3)] void Main(triangle V i[3], inout TriangleStream<V> s)\n{\n"
           "    for (int k = 0; k < 3; ++k)\n    {\n        V o;\n        o.p = i[k].p;\n" +
           set + "        s.Append(o);\n    }\n}\n";
  };
  EXPECT_THAT(reads(shader("        o.uv = i[k].uv;\n"), hlsl::Stage::geometry), IsEmpty());
  EXPECT_THAT(reads(shader(""), hlsl::Stage::geometry),
              ElementsAre("8:18 warning read-before-set: 'o.uv' is read but never set"));
}

TEST(OutputNotSet, AStreamOfAGeometryShaderIsNoValue) {
  const auto shader = [](const std::string& helper) {
    return "struct V { float4 p : SV_Position; };\n" + helper +
           "[maxvertexcount(3)] void Main(triangle V i[3], inout TriangleStream<V> stream)\n{\n"
           "    for (int k = 0; k < 3; ++k) Emit(i[k], stream);\n}\n";
  };
  EXPECT_THAT(outputs(shader("void Emit(V v, inout TriangleStream<V> stream) { stream.Append(v); }\n"),
                      hlsl::Stage::geometry),
              IsEmpty());
  EXPECT_THAT(
      outputs(shader("void Emit(V v, inout TriangleStream<V> stream, out float x) { stream.Append(v); }\n"
                     "void Emit(V v, inout TriangleStream<V> stream) { float x; Emit(v, stream, x); }\n"),
              hlsl::Stage::geometry),
      ElementsAre(testing::HasSubstr("out parameter 'x' of 'Emit'")));
}

}  // namespace
}  // namespace penumbra::lint
