// Sources that Unity's compilers refuse are refused at their place, and nothing that they take is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <functional>

#include "hlsl/token_place.h"
#include "preparation/prepare.h"

namespace penumbra::preparation {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> said(const std::string& text, const EntryPoint& entry = {"Frag"}) {
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& note : prepare(text, "a", entry).notes)
    all.push_back(std::to_string(note.line) + ":" +
                  (note.severity == hlsl::Severity::error ? " error: " : " warning: ") + note.message);
  return all;
}

std::string fragment(const std::string& body) {
  return "int n;\nfloat4 Frag(float4 p : SV_Position) : SV_Target {\n" + body + "\nreturn 1; }\n";
}

std::vector<std::string> said_of_cases(const std::string& cases) {
  return said(fragment("float v = 0; switch (n) {\n" + cases + "\n}"));
}

TEST(SourceChecks, SayWhichOfTheLinesTokensIsMeant) {
  const std::string line =
      "int n; int Two() { switch (n) { case 0: case 1: n = 1; case 2: break; } return 2; }";
  const std::vector<Note> notes = prepare(line, "a", EntryPoint{"Frag"}).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].spelling, "case");
  EXPECT_EQ(notes[0].rank, 1U);
  EXPECT_EQ(notes[0].count, 3U);
  EXPECT_EQ(hlsl::column_in(line, notes[0].spelling, notes[0].rank, notes[0].count), 41);
}

TEST(SwitchCases, WithCodeEndInBreakOrReturn) {
  EXPECT_THAT(
      said_of_cases("case 0: v = 1;\ncase 1: v += 2; break;"),
      ElementsAre("4: error: this case has code and ends without break or return, and HLSL does not fall "
                  "through: end it with break, or repeat the code of the next one"));
  EXPECT_THAT(said_of_cases("case 0: break;\ncase 1: v = 1;"), ElementsAre(HasSubstr("5: error: this case")));
  EXPECT_THAT(said_of_cases("case 0: break;\ndefault: discard;"),
              ElementsAre(HasSubstr("5: error: this case")));
  EXPECT_THAT(said_of_cases("case 0: if (n > 2) break;\ndefault: break;"),
              ElementsAre(HasSubstr("4: error: this case")));
  EXPECT_THAT(said_of_cases("case 3 ? 1 : 2: { v = 1; }\ncase 3: break;"),
              ElementsAre(HasSubstr("4: error: this case")));
}

TEST(SwitchCases, MayShareCodeAndEndInManyWays) {
  EXPECT_THAT(said_of_cases("case 0: case 1: v = 1; break; default: case 3: break;"), IsEmpty());
  EXPECT_THAT(said_of_cases("case 0: { v = 1; break; } case 1: { v = 2; } break; case A::b: return 2;"),
              IsEmpty());
  EXPECT_THAT(
      said_of_cases("case 0: if (n) { return 1; } else if (v) return 2; else { break; } case 1: break;"),
      IsEmpty());
  EXPECT_THAT(said_of_cases("case 0: v = 1; if (true) break; v = 9; case 1: if (false) break; v = 2; break;"),
              IsEmpty());
  EXPECT_THAT(said_of_cases(
                  "case 0: [branch] if (n) { v = 1; } ; [unroll] for (int i = 0; i < 2; ++i) v += i; break;"),
              IsEmpty());
  EXPECT_THAT(said_of_cases("case 0: switch (n) { case 1: return 1; default: return 2; } case 1: break;"),
              IsEmpty());
}

// A closing bracket behind a keyword is no condition, so the check does not go on behind it.
TEST(SwitchCases, ABrokenConditionIsPassedOnce) {
  EXPECT_THAT(said_of_cases("case 0: { n = 1; if } v = 2; break;"), IsEmpty());
}

TEST(SwitchCases, EndInAStatementAndContinueNoLoopAround) {
  EXPECT_THAT(said_of_cases("case 0: return 1;\ndefault:"),
              ElementsAre("5: error: the last case of a switch is empty: write break"));
  EXPECT_THAT(said_of_cases("case 0: return 1;\ndefault: ;"), IsEmpty());
  const std::string loop = "for (int i = 0; i < n; ++i) {\n";
  EXPECT_THAT(
      said(fragment(loop + "switch (n) {\ncase 0: if (i > 2) { continue; } break; } }")),
      ElementsAre("5: error: HLSL has no continue in a switch: set a variable, and continue after the "
                  "switch"));
  EXPECT_THAT(said(fragment(loop + "switch (n) { case 0: " + loop +
                            "if (i > 2) continue; }\ndo { if (n) continue; "
                            "} while (n > 8); break; }\nif (n > 3) continue; }")),
              IsEmpty());
}

TEST(SwitchCases, FallThroughForDxc) {
  const std::string text = fragment("float v = 0; switch (n) { case 0: v = 1; case 1: break; }");
  EXPECT_THAT(said(text, {"Frag", hlsl::Stage::fragment, true}), IsEmpty());
}

TEST(SwitchCases, OfAnyDepthAreReadWithoutHarm) {
  std::string deep;
  for (int i = 0; i < 900; ++i) deep += "if (n) ";
  EXPECT_THAT(said_of_cases("case 0: " + deep + "break;"), ElementsAre(HasSubstr("4: error: this case")));
}

TEST(BaseStructs, AreDeclaredBefore) {
  const std::string frag = "float4 Frag() : SV_Target { return 1; }";
  EXPECT_THAT(said("struct A {\nint a; };\nstruct B :\nA { int b; };" + frag), ElementsAre());
  EXPECT_THAT(said("struct B :\nA { int b; };" + frag),
              ElementsAre("2: error: 'A' is not a struct declared before 'B', which derives from it"));
  EXPECT_THAT(said("struct A :\nB { int a; }; struct B :\nA { int b; }; A f(B b) { return b; }" + frag),
              ElementsAre("1: error: 'A' contains itself"));
  EXPECT_THAT(said("struct A :\nA { int a; };" + frag), ElementsAre("1: error: 'A' contains itself"));
}

TEST(BaseStructs, AreSixteenAtMost) {
  const auto chain = [](int bases) {
    std::string text = "struct S0 { int a; };\n";
    for (int i = 1; i <= bases; ++i)
      text += "struct S" + std::to_string(i) + " : S" + std::to_string(i - 1) + " { int b" +
              std::to_string(i) + "; };\n";
    return text + "float4 Frag() : SV_Target { return 1; }";
  };
  EXPECT_THAT(said(chain(16)), ElementsAre());
  EXPECT_THAT(said(chain(17)), ElementsAre("18: error: 'S17' has more than 16 levels of base structs"));
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
              ElementsAre("7: error: 'S6' has more than 65536 members, those of the structs in it included"));
  EXPECT_THAT(said("struct S {\nS s; };" + frag), ElementsAre("1: error: 'S' contains itself"));
  EXPECT_THAT(said("struct A { B b; };\nstruct B { A a; };" + frag),
              ElementsAre(HasSubstr("contains itself")));
}

TEST(CaseLabels, OfConstantsThatAreMadeOfMany) {
  const std::string text = levels("static const int c0 = 1;\n", [](int i) {
    std::string line = "static const int c" + std::to_string(i) + " = 0";
    for (int k = 0; k < 8; ++k) line += " + c" + std::to_string(i - 1);
    return line + ";\n";
  });
  const std::string frag =
      "float4 Frag(nointerpolation int n : TEXCOORD0) : SV_Target { switch (n) {\ncase c23: return 1; "
      "default: return 2; } }";
  EXPECT_THAT(said(text + frag), ElementsAre());
  EXPECT_THAT(said("int u;\n" + text.substr(0, 22) + "u" + text.substr(23) + frag),
              ElementsAre(HasSubstr("27: error: a case label must be a constant")));
}

TEST(EntrySemantics, AreThereOnEveryInputAndOutput) {
  EXPECT_THAT(said("float4 Frag(float4 p : SV_Position,\nfloat2 uv) : SV_Target { return 1; }"),
              ElementsAre("2: error: 'uv' has no semantic, and is an input of the fragment program"));
  EXPECT_THAT(
      said("float4 Frag(float4 p : SV_Position)\n{ return 1; }"),
      ElementsAre("1: error: what 'Frag' returns has no semantic, and is an output of the fragment program"));
  EXPECT_THAT(
      said("struct I { float4 p : SV_Position;\nfloat2 uv, st : TEXCOORD1; };\nfloat4 Frag(I i) : SV_Target "
           "{ return 1; }"),
      ElementsAre("2: error: 'uv' has no semantic, and is an input of the fragment program"));
  EXPECT_THAT(
      said("struct A {\nhalf3 n[2]; };\nstruct B : A { float4 c : SV_Target; };\nvoid Frag(out B b) { }"),
      ElementsAre("2: error: 'n' has no semantic, and is an output of the fragment program"));
  EXPECT_THAT(
      said(
          "struct V { float4 p : SV_Position;\nfloat2 uv; };\n[maxvertexcount(3)] void Frag(triangle V v[3], "
          "inout TriangleStream<V> s) { }",
          {"Frag", hlsl::Stage::geometry}),
      ElementsAre("2: error: 'uv' has no semantic, and is an input of the geometry program"));
}

TEST(EntrySemantics, AreTheStagesOwn) {
  EXPECT_THAT(said("float4 Frag(float4 p : SV_Positon) :\nSV_Traget { return 1; }"),
              testing::UnorderedElementsAre(
                  "1: error: 'SV_Positon' is not a system value of HLSL; did you mean 'SV_Position'?",
                  "2: error: 'SV_Traget' is not a system value of HLSL; did you mean 'SV_Target'?"));
  EXPECT_THAT(said("float4 Frag() : TEXCOORD0 { return 1; }"),
              ElementsAre("1: error: 'TEXCOORD0' is not an output of a fragment program"));
  EXPECT_THAT(said("[numthreads(1,1,1)] void Frag(uint3 id : TEXCOORD0) { }", {"Frag", hlsl::Stage::compute}),
              ElementsAre(HasSubstr("1: error: 'TEXCOORD0' is not an input of a compute program")));
  EXPECT_THAT(
      said("float4 Frag(float4 p : POSITON) : SV_Position { return p; }", {"Frag", hlsl::Stage::vertex}),
      ElementsAre(
          "1: warning: 'POSITON' is not a vertex attribute of Unity's meshes; did you mean 'POSITION'?"));
}

TEST(EntrySemantics, OfSystemValuesAreThoseOfTheStage) {
  EXPECT_THAT(said("float4 Frag(uint v : SV_VertexID) : SV_Target { return v; }"),
              ElementsAre("1: error: 'SV_VertexID' is not an input of a fragment program"));
  EXPECT_THAT(
      said("float4 Frag(float4 p : SV_Target) : SV_Position { return p; }", {"Frag", hlsl::Stage::vertex}),
      ElementsAre("1: error: 'SV_Target' is not an input of a vertex program"));
  EXPECT_THAT(said("float4 Frag(out uint v : SV_VertexID) : SV_Position { v = 0; return 1; }",
                   {"Frag", hlsl::Stage::vertex}),
              ElementsAre("1: error: 'SV_VertexID' is not an output of a vertex program"));
  EXPECT_THAT(
      said("struct V { float4 p : SV_POSITION; uint i : SV_InstanceID; uint l : SV_RenderTargetArrayIndex; "
           "float c[2] : SV_ClipDistance0; };\nV Frag(float4 p : SV_Position, uint v : SV_VertexID, uint i : "
           "SV_InstanceID) { V o; return o; }",
           {"Frag", hlsl::Stage::vertex}),
      IsEmpty());
  EXPECT_THAT(
      said("float4 Frag(float4 p : SV_Position, bool f : SV_IsFrontFace, uint s : SV_SampleIndex, uint c : "
           "SV_Coverage, uint k : SV_PrimitiveID, uint i : SV_InstanceID, float x : MYSEM0) : SV_Target7 { "
           "return f; }"),
      IsEmpty());
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
  EXPECT_THAT(
      said("struct O { float4 a : SV_Target0; float4 b : COLOR; };\nO Main() { O o; return o; }", fragment),
      ElementsAre(
          "1: error: 'COLOR' is Direct3D 9's name of 'SV_Target', which the program has, too: write one of "
          "them"));
}

TEST(EntrySemantics, MayComeFromAroundAndInOldWords) {
  EXPECT_THAT(said("void Frag(inout half4 c : SV_Target) { }"), IsEmpty()) << "framebuffer fetch";
  EXPECT_THAT(said("float4 Frag(float2 uv : ) : SV_Target { return 1; }"), IsEmpty())
      << "the parser's to report";
  EXPECT_THAT(
      said("struct In { struct { float2 uv : TEXCOORD0; } m; };\nstruct A { float a; float2 b; "
           "float Sum() { return a; } float d(int x); };\nstruct Out { half4 a : SV_TARGET0; "
           "float d : sv_depth; };\nOut Frag(In i, A a : CASCADE, uniform float k, Texture2D t, bool f : "
           "SV_IsFrontFace, float face : VFACE) { Out o; return o; }"),
      IsEmpty());
  EXPECT_THAT(said("float4 Frag() : COLOR { return 1; }"), IsEmpty());
  EXPECT_THAT(said("float4 Frag(float t : A) : bogus : SV_Target { return 1; }"), IsEmpty());
  EXPECT_THAT(said("void Frag(float4 p : SV_Position, out float4 c : SV_Target, out float d : SV_Depth) { }"),
              IsEmpty());
  EXPECT_THAT(said("struct V { precise nointerpolation min16float3 n : NORMAL; real_t r; };\nvoid Frag(const "
                   "V v) { }"),
              IsEmpty());
  EXPECT_THAT(
      said("struct C { float3 p : INTERNALTESSPOS; }; float3 Patch() { return 1; }\n[domain(\"tri\")] "
           "[partitioning(\"integer\")] [outputtopology(\"triangle_cw\")] [outputcontrolpoints(3)] "
           "[patchconstantfunc(\"Patch\")] C Frag(InputPatch<C, 3> patch, uint id : "
           "SV_OutputControlPointID) { return patch[id]; }",
           {"Frag", hlsl::Stage::hull}),
      IsEmpty());
  EXPECT_THAT(said("float4 Vert() { return 1; }"), IsEmpty()) << "no entry point";
}

TEST(ConstantDivisions, OfIntegersByZeroAreRefused) {
  EXPECT_THAT(said(fragment("int a = 1 / 0;")), ElementsAre("3: error: an integer is divided by zero"));
  EXPECT_THAT(said("static const int N = 0;\n" + fragment("int a = 8u % N;")),
              ElementsAre("4: error: an integer is divided by zero"));
  EXPECT_THAT(said("static const uint A = 3;\n" + fragment("int a = A / 0x0;")),
              ElementsAre("4: error: an integer is divided by zero"));
  EXPECT_THAT(
      said("static const int N = 0;\n" +
           fragment("float a = 1.0 / 0; float b = 1 / 0.0; int c = N > 0 ? 8 / N : 0; int d = 8 / n;")),
      IsEmpty());
}

std::string missing(const std::string& words) {
  return "error: expected ';' before '" + words + "'";
}

// glslang takes each of these without a word.
TEST(Semicolons, AreMissedBeforeADeclarationOfAScalar) {
  EXPECT_THAT(said(fragment("float x = 1\nfloat y = 2;")), ElementsAre("4: " + missing("float y")));
  EXPECT_THAT(said(fragment("int i = n\nint j = 2;")), ElementsAre("4: " + missing("int j")));
  EXPECT_THAT(said(fragment("float x = sin(p.x)\nhalf y = 2;")), ElementsAre("4: " + missing("half y")));
  EXPECT_THAT(said(fragment("float a[2] = { 1, 2 }; float b = a[1]\nbool c = true;")),
              ElementsAre("4: " + missing("bool c")));
  EXPECT_THAT(said("float _A\nfloat _B;\n" + fragment("")), ElementsAre("2: " + missing("float _B")));
  EXPECT_THAT(said("struct S { float a : A\nuint b : B; };\n" + fragment("")),
              ElementsAre("2: " + missing("uint b")));
}

TEST(Semicolons, AreMissedNowhereElse) {
  EXPECT_THAT(
      said("static const float k[2] = { 1, 2 }; groupshared uint g; row_major float4x4 m;\n"
           "float F(const float a, in int b, out half c, inout bool d, nointerpolation uint e = 2) {\n"
           "  [unroll] for (int i = 0; i < 2; ++i) float u = (float)i;\n"
           "  [loop] while (d) int w = 1;\n"
           "  if (d) float x = 1; else float y = 2;\n"
           "  do int z = 3; while (d);\n"
           "  switch (b) { case 0: float q = 1; break; default: int r = 2; break; }\n"
           "  unsigned int v = uint(a) + uint(float(b)); precise float s = k[1];\n"
           "  return float(v) * float2(1, 2).x; }\n" +
           fragment("")),
      IsEmpty());
}

TEST(ThreadGroup, IsNeededByAComputeProgram) {
  const EntryPoint kernel{"Main", hlsl::Stage::compute};
  const std::string body = "void Main(uint3 id : SV_DispatchThreadID) { }\n";
  EXPECT_THAT(said("int n;\n" + body, kernel),
              ElementsAre("2: error: 'Main' has no [numthreads(x, y, z)], which a compute program needs"));
  EXPECT_THAT(said("[numthreads(8, 8, 1)]\n" + body, kernel), IsEmpty());
  EXPECT_THAT(said("[RootSignature(\"\")][numthreads(8, 8, 1)] " + body, kernel), IsEmpty());
  EXPECT_THAT(said("[numthreads(8, 8, 1)] void Other() { }\n" + body, kernel),
              ElementsAre(HasSubstr("'Main' has no")));
  EXPECT_THAT(said(fragment("")), IsEmpty());
}

std::string counted(const std::string& name, const std::string& holds, const std::string& has) {
  return "error: '" + name + "' holds " + holds + ", and its initialiser has " + has +
         "; give it one value for each, or cast one to the whole type";
}

TEST(InitialiserCounts, AreThoseOfTheValue) {
  EXPECT_THAT(said(fragment("float3 a = {1, 2};")), ElementsAre("3: " + counted("a", "3 numbers", "2")));
  EXPECT_THAT(said(fragment("float a[2] = {1, 2, 3};")), ElementsAre("3: " + counted("a", "2 numbers", "3")));
  EXPECT_THAT(said(fragment("float a[2][2] = {{1, 2}, {3}};")),
              ElementsAre("3: " + counted("a", "4 numbers", "3")));
  EXPECT_THAT(said("static const float2 k = {1, 2, 3};\n" + fragment("")),
              ElementsAre("1: " + counted("k", "2 numbers", "3")));
  EXPECT_THAT(said("struct S { float a; float2 b; };\n" + fragment("S s = {1, 2};")),
              ElementsAre("4: " + counted("s", "3 numbers", "2")));
  EXPECT_THAT(said(fragment("float2 a = {p.x + 1, p.y, n};")),
              ElementsAre("3: " + counted("a", "2 numbers", "at least 3")));
  EXPECT_THAT(said(fragment("float a = {1, -2};")), ElementsAre("3: " + counted("a", "1 number", "2")));
}

TEST(InitialiserCounts, AreNotGuessed) {
  EXPECT_THAT(
      said("struct S { float a; float2 b; };\nstatic const int N = 2;\nS Get();\n" +
           fragment("float3 a = {1, p.xy}; float b[] = {1, 2, 3}; float c[N] = {1, 2, 3};\n"
                    "S s = {1, 2, 3,}; S t[2] = {s, {1, {2, 3}}}; float2x2 m = {1, 2, 3, 4};\n"
                    "float2 d[2] = {1, 2, float2(3, 4)}; float4 e = {mul(m, d[0]), d[1]}; float f = {1};\n"
                    "float4 g = {abs(p)}; S u = {Get()}; S v = (S)0; float3 h = {p.x, p.yz * 2};")),
      IsEmpty());
}

TEST(Constructors, TakeAllNumbersOfTheirType) {
  EXPECT_THAT(said(fragment("float4 a = float4(0);")),
              ElementsAre("3: error: the constructor float4 takes 4 numbers, and has 1; to repeat it, write "
                          "(float4)x"));
  EXPECT_THAT(said(fragment("float2x2 m = float2x2(p.xy, -1);")),
              ElementsAre("3: error: the constructor float2x2 takes 4 numbers, and has 3"));
  EXPECT_THAT(said(fragment(
                  "float a = float(n); float2 b = float2(p.xy); float3 c = float3(p.x * 2, 1, Unknown()); "
                  "float3x3 m; float2x2 k = float2x2(m); int4 i = int4(1, n, p.zw); float2 d = float2(p);")),
              IsEmpty());
}

TEST(Swizzles, HaveTheLettersOfHlsl) {
  const std::string words = "' is not a swizzle of HLSL, which has xyzw and rgba: write '.";
  EXPECT_THAT(said(fragment("float4 a = p.stpq;")), ElementsAre("3: error: '.stpq" + words + "xyzw'"));
  EXPECT_THAT(said(fragment("float4 a = 1;\na.ts = p.xy;")), ElementsAre("4: error: '.ts" + words + "yx'"));
  EXPECT_THAT(said("Texture2D m; SamplerState s;\n" + fragment("float2 a = m.Sample(s, p.xy).st;")),
              ElementsAre("4: error: '.st" + words + "xy'"));
  EXPECT_THAT(
      said("struct S { float2 s; };\n" + fragment("S a; a.s = (p * 2).st; float b = a.s.s;")),
      testing::UnorderedElementsAre("4: error: '.st" + words + "xy'", "4: error: '.s" + words + "x'"));
}

TEST(Swizzles, MayBeCalledLikeMembers) {
  EXPECT_THAT(said("struct S { float4 s, st; float2 p() { return st.xy; } };\n" +
                   fragment("S t; t.s = t.st; float2 a = t.s.xy + t.p();")),
              IsEmpty());
}

TEST(Strings, AreReadByNobody) {
  const std::string ignored = "warning: shaders do not read strings: this variable has no effect";
  EXPECT_THAT(said("string s = \"a\";\n" + fragment("string t = \"a\"; string u[2];")),
              ElementsAre("1: " + ignored, "4: " + ignored, "4: " + ignored));
  EXPECT_THAT(
      said("string s = \"a\";\n" + fragment("string t = \"a\";"), {"Frag", hlsl::Stage::fragment, true}),
      ElementsAre("1: " + ignored,
                  "4: error: strings may only be declared at file scope, and shaders do not read "
                  "them: remove it"));
}

std::string repeated(const std::string& name, const std::string& place) {
  return "error: '" + name + "' is already declared, at " + place + ": remove one of the two";
}

TEST(Globals, AreDeclaredOnce) {
  EXPECT_THAT(said("float _A;\nfloat _A;\n" + fragment("")), ElementsAre("2: " + repeated("_A", "a:1")));
  EXPECT_THAT(said("float _A;\nfloat4 _A;\n" + fragment("")), ElementsAre("2: " + repeated("_A", "a:1")));
  EXPECT_THAT(said("cbuffer C {\nfloat _A; float _B; };\nstatic float _C, _B;\n" + fragment("")),
              ElementsAre("3: " + repeated("_B", "a:2")));
  EXPECT_THAT(said("Texture2D<float4> _T : register(t0);\n#line 7 \"b\"\nTexture2D _T;\n" + fragment("")),
              ElementsAre("7: " + repeated("_T", "a:1")));
}

TEST(Globals, MayBeCalledLikeOtherThings) {
  EXPECT_THAT(
      said("struct A { float a; }; struct B { float a; }; A A2; float F(float x); float F(float x);\n"
           "float F(float x) { float a = x; { float a = 2; } return a; } float2 F(float2 x) { return x; }\n"
           "extern float e; extern float e; namespace N { float g; } namespace M { float g; } float g;\n"
           "cbuffer P { float p1; }; cbuffer P { float p2; };\n" +
           fragment("float e2, g2; float F2 = 1;")),
      IsEmpty());
}

std::string shared(const std::string& first, const std::string& semantic, const std::string& what) {
  return "'" + first + " has the semantic '" + semantic + "', too: give each " + what + " its own";
}

TEST(Semantics, AreEachOfOneOutput) {
  EXPECT_THAT(
      said("struct O { float4 a : SV_Target;\nfloat4 b : sv_target0; };\nO Frag() { O o; return o; }"),
      ElementsAre("2: error: " + shared("a' at a:1", "sv_target0", "output")));
  EXPECT_THAT(said("struct V { float4 p : SV_Position; float3x2 m : A;\nfloat2 b : A1; };\nV Frag(float4 p : "
                   "POSITION) { V v; return v; }",
                   {"Frag", hlsl::Stage::vertex}),
              ElementsAre("2: error: " + shared("m' at a:1", "A1", "output")));
}

TEST(Semantics, OfInputsAreSharedByOneType) {
  const std::string same =
      "float4 Frag(float2 a[2] : TEXCOORD1, float2 b : TEXCOORD0,\nfloat2 c : TEXCOORD2) : "
      "SV_Target { return 1; }";
  EXPECT_THAT(said(same), ElementsAre("2: warning: " + shared("a' at a:1", "TEXCOORD2", "input")));
  EXPECT_THAT(said(same, {"Frag", hlsl::Stage::fragment, true}),
              ElementsAre("2: error: " + shared("a' at a:1", "TEXCOORD2", "input")));
  EXPECT_THAT(said("float4 Frag(float2 a : COLOR,\nfloat4 b : Color0) : SV_Target { return b; }"),
              ElementsAre("2: error: " + shared("a' at a:1", "Color0", "input")));
  EXPECT_THAT(
      said("float4 Frag(float4 a : POSITION, uint b : SV_VertexID,\nuint c : SV_VertexID) : SV_Position { "
           "return b; }",
           {"Frag", hlsl::Stage::vertex}),
      ElementsAre("2: error: " + shared("b' at a:1", "SV_VertexID", "input")));
}

TEST(Semantics, MayBeOfAnInputAndAnOutput) {
  EXPECT_THAT(said("struct V { float4 p : SV_Position; float2 a[2] : T; float2 b : T2; };\nV Frag(float4 p : "
                   "POSITION, float2 q : T) { V v; return v; }",
                   {"Frag", hlsl::Stage::vertex}),
              IsEmpty());
}

TEST(BitComplements, AreOfIntegers) {
  EXPECT_THAT(
      said(fragment("float f = 1;\nfloat g = ~f;")),
      ElementsAre("4: error: '~' takes integers, and its operand is a float: convert it with (int), or "
                  "read its bits with asuint()"));
  EXPECT_THAT(said(fragment("uint2 f = ~asuint(p.xy); int g = ~n; bool b = !p.x; g = ~Unknown(p);")),
              IsEmpty());
}

TEST(PackedMembers, DoNotOverlap) {
  const auto told = [](const std::string& later, const std::string& earlier) {
    return "2: error: the packoffset of '" + later + "' lies in '" + earlier +
           "': give them offsets that do not overlap";
  };
  EXPECT_THAT(said("cbuffer C { float4 a : packoffset(c0);\nfloat b : packoffset(c0.y); }\n" + fragment("")),
              ElementsAre(told("b", "a")));
  EXPECT_THAT(said("cbuffer C { float3x3 a : packoffset(c1); float b : packoffset(c4);\nfloat4 c[2] : "
                   "packoffset(c0); }\n" +
                   fragment("")),
              ElementsAre(told("c", "a")));
  EXPECT_THAT(
      said("cbuffer C { float4 a : packoffset(c1); float b : packoffset(c0.y); float2 c : packoffset(c0.z); "
           "float d[3] : packoffset(c2); float e : packoffset(c4.y); }\ncbuffer D { float f : "
           "packoffset(c0); }\n" +
           fragment("")),
      IsEmpty());
}

TEST(MissingValues, AreErrorsOfWhatIsCalled) {
  const std::string rest =
      "' has no return statement: return a value, or make it void (not all control paths return a value, "
      "X3507)";
  const auto errors = [](const std::string& text) {
    std::vector<std::string> all = said(text);
    std::erase_if(all, [](const std::string& one) { return one.find("error") == std::string::npos; });
    return all;
  };
  EXPECT_THAT(errors("float F(float x) { x = 1; }\nfloat G() { return F(1); }\n" + fragment("G();")),
              ElementsAre("1: error: 'F" + rest));
  EXPECT_THAT(errors("\nfloat4 Frag() : SV_Target { discard; }"), ElementsAre("2: error: 'Frag" + rest));
  EXPECT_THAT(errors("float F(float x) { x = 1; }\nvoid V() { }\nfloat H() { return F(1); }\n" +
                     fragment("float F = 1; V();")),
              IsEmpty())
      << "F is not called";
  EXPECT_THAT(errors("float F(float x) { x = 1; }\nfloat F(float2 x) { return 1; }\n" + fragment("F(p.xy);")),
              IsEmpty())
      << "the other F is called";
}

TEST(Interfaces, AreNotSupported) {
  EXPECT_THAT(
      said("interface I { float F(); };\nclass C : I { float F() { return 1; } };\n" + fragment("")),
      ElementsAre(
          "1: error: not supported here: interfaces, such as 'I'; take it out, name the struct itself "
          "where a parameter or variable has its type, and choose between structs with #if"));
  EXPECT_THAT(said(fragment("float interface = 1;")), IsEmpty());
}

TEST(MethodBodies, AreMissedWhereTheyAreCalled) {
  EXPECT_THAT(said("struct S { float a; float F(float x); float G(float x); };\n" + fragment("S s; s.F(1);")),
              ElementsAre("1: error: 'F' of 'S' has no body: write it into the struct"));
}

}  // namespace
}  // namespace penumbra::preparation
