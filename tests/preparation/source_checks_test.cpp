// Checks of sources that no file of refused/ or taken/ holds: large ones, made here; what a check leaves
// behind in the text; and HLSL that the checks take and glslang does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "preparation/prepare.h"

namespace penumbra::preparation {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> said(const std::string& text) {
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& note : prepare(text, "a", EntryPoint{"Frag"}).notes)
    all.push_back(std::to_string(note.line) +
                  (note.severity == hlsl::Severity::error ? ": " : ": warning: ") + note.message);
  return all;
}

std::string fragment(const std::string& body) {
  return "int n;\nfloat4 Frag(float4 p : SV_Position) : SV_Target {\n" + body + "\nreturn 1; }\n";
}

std::string repeated(const std::string& part, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += part;
  return all;
}

// Each level has eight of the level before, so a check that looks at every path does not end.
std::string levels(const std::string& first, const std::function<std::string(int)>& next) {
  std::string text = first;
  for (int i = 1; i < 24; ++i) text += next(i);
  return text;
}

TEST(StructSizes, AreLimited) {
  const std::string frag = "float4 Frag() : SV_Target { return 1; }";
  const std::string text = levels("struct S0 { float a; };\n", [](int i) {
    std::string line = "struct S" + std::to_string(i) + " {";
    for (int k = 0; k < 8; ++k) line += " S" + std::to_string(i - 1) + " m" + std::to_string(k) + ";";
    return line + " };\n";
  });
  EXPECT_THAT(said(text + "cbuffer C { S23 s; float3x3 f; float g; };" + frag),
              ElementsAre("7: 'S6' has more than 65536 members, those of the structs in it included"));
  for (const char* recursive :
       {"struct S {\nS s; };", "struct S { T t; };\nstruct T { S s; };", "struct S :\nS { int a; };",
        "struct S :\nT { int a; }; struct T :\nS { int b; }; S f(T b) { return b; }"})
    EXPECT_THAT(said(recursive + frag), ElementsAre("1: 'S' contains itself"));
}

std::string with_semantics(const std::string& text, const EntryPoint& entry) {
  return prepare(text, "a", entry).text;
}

TEST(EntrySemantics, OfDirect3D9AreSystemValuesWhereTheirDirectionSaysSo) {
  const EntryPoint vertex{"Main", hlsl::Stage::vertex};
  const EntryPoint fragment{"Main", hlsl::Stage::fragment};
  EXPECT_THAT(
      with_semantics(
          "struct V { float4 p : Position; }; V Main(float4 v : POSITION) { V o; o.p = v; return o; }",
          vertex),
      AllOf(HasSubstr("p : SV_Position ;"), HasSubstr("v : POSITION)")));
  EXPECT_THAT(with_semantics("struct O { float4 c : COLOR1; float4 e : COLOR; float d : DEPTH; };\n"
                             "O Main(float4 p : VPOS, float4 c : COLOR) { O o; return o; }",
                             fragment),
              AllOf(HasSubstr("c : SV_Target1 ;"), HasSubstr("e : SV_Target ;"), HasSubstr("d : SV_Depth ;"),
                    HasSubstr("p : SV_Position ,"), HasSubstr("c : COLOR)")));
  EXPECT_THAT(with_semantics("struct V { float4 c : COLOR; }; V Main(V v) { return v; }", fragment),
              HasSubstr("c : COLOR;"));
  EXPECT_THAT(with_semantics("void Main(inout float4 p : POSITION, inout half2 u : U) { p.z = 0; }", vertex),
              HasSubstr("in float4 p_in : POSITION, out float4 p : SV_Position , inout half2 u : U) "
                        "{ p = p_in; p.z = 0; }"));
  EXPECT_THAT(with_semantics("void Main(inout precise float4 c : COLOR1) { }", fragment),
              HasSubstr("in float4 c_in : COLOR1, out precise float4 c : SV_Target1 ) { c = c_in; }"));
  EXPECT_THAT(with_semantics("float4 Main(float4 p : POSITION) : POSITION { return p; }",
                             {"Main", hlsl::Stage::vertex, true}),
              HasSubstr(") : POSITION"))
      << "DXC";
  EXPECT_THAT(with_semantics("float4 Main(float4 p : POSITION) : POSITION { return p; }",
                             {"Main", hlsl::Stage::vertex, false, false}),
              HasSubstr(") : POSITION"))
      << "read by a geometry program";
}

TEST(Nesting, HasALimit) {
  const auto is_deep = ElementsAre("3: more than 1000 levels of nesting: split it");
  EXPECT_THAT(said(fragment("return " + repeated("(", 20000) + "p" + repeated(")", 20000) + ";")), is_deep);
  EXPECT_THAT(said(fragment("return " + repeated("- ", 50000) + "p;")), is_deep);
  EXPECT_THAT(said(fragment("return " + repeated("(int)", 20000) + "p;")), is_deep);
  EXPECT_THAT(said(fragment(repeated("if (n) ", 20000) + ";")), is_deep);
  EXPECT_THAT(said(fragment("return " + repeated("p + ", 20000) + "p;")),
              ElementsAre("3: more than 8000 operators in one expression: split it"));
  EXPECT_THAT(said(fragment("return " + repeated("(", 900) + "p" + repeated(")", 900) + ";")), IsEmpty());
  EXPECT_THAT(said(fragment(repeated("n = -n * 2;", 20000))), IsEmpty());
}

// glslang would crash.
TEST(ClipDistances, ThatAreUnsupportedAreErrors) {
  const std::vector<Note> notes =
      prepare("[maxvertexcount(1)] void Main(point float c[1] : SV_ClipDistance0, inout PointStream<V> s) {}",
              "a", EntryPoint{"Main", hlsl::Stage::geometry})
          .notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0].message, HasSubstr("'SV_ClipDistance0' cannot be read in a geometry program here"));
  EXPECT_EQ(notes[0].severity, hlsl::Severity::error);
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

// glslang refuses some of these, which Unity's compilers take, and reports the others itself.
TEST(SourceChecks, LeaveToGlslangWhatTheyDoNotKnow) {
  EXPECT_THAT(said("float const a; float4 f() { return 0.xxxx; }\n" + fragment("")), IsEmpty());
  EXPECT_THAT(said("struct S { float a; float2 b; }; S Get();\n" + fragment("S s = {Get()};")), IsEmpty());
  EXPECT_THAT(said("static const int N = 2;\n" + fragment("float c[N] = {1, 2, 3};")), IsEmpty());
  EXPECT_THAT(said(fragment("float3 c = float3(p.x * 2, 1, Unknown()); int g = ~Unknown(p);")), IsEmpty());
}

}  // namespace
}  // namespace penumbra::preparation
