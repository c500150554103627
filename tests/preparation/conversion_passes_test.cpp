// Tests casts of structs, matrices of two sizes and statics that call functions: what is put there, and what
// must stay.
#include <gmock/gmock.h>

#include "preparation/after_pass.h"
#include "preparation/passes.h"

namespace penumbra::preparation {
namespace {

const std::string kPair =
    "struct A { float4 p : POSITION; half2 u[2] : A; }; struct B { float4 q : B; half2 v[2]; }; ";

TEST(StructCasts, CopyMemberByMember) {
  EXPECT_EQ(after<copy_cast_structs>(kPair + "B f(A a) { return (B)a; }"),
            kPair +
                "B B_of_A(A from) { B to; to.q = from.p; to.v = from.u; return to; } "
                "B f(A a) { return B_of_A( a ) ; }");
  EXPECT_EQ(
      after<copy_cast_structs>(kPair +
                               "A g(); void f() { A a[2]; B b; b = (B)a[1]; b = (B)g(); b = (B)(a[0]); }"),
      kPair +
          "B B_of_A(A from) { B to; to.q = from.p; to.v = from.u; return to; } "
          "A g(); void f() { A a[2]; B b; b = B_of_A( a[1] ) ; b = B_of_A( g() ) ; b = B_of_A( (a[0]) ) ; }");
}

TEST(StructCasts, ToTheirOwnTypeGo) {
  EXPECT_EQ(after<copy_cast_structs>(kPair + "A f(A a) { return (A)a; }"), kPair + "A f(A a) { return a; }");
}

TEST(StructCasts, PrecisionIsNoDifferenceAndShapeIs) {
  const std::string declarations = "struct A { float3 x; }; struct B { half3 x; }; struct C { half4 x; }; ";
  EXPECT_EQ(
      after<copy_cast_structs>(declarations + "B f(A a) { return (B)a; }"),
      "struct A { float3 x; }; struct B { half3 x; }; B B_of_A(A from) { B to; to.x = from.x; return to; } "
      "struct C { half4 x; }; B f(A a) { return B_of_A( a ) ; }");
  for (const char* text : {"C f(A a) { return (C)a; }", "A f(C c) { return (A)c; }"})
    EXPECT_EQ(after<copy_cast_structs>(declarations + text), declarations + text);
}

TEST(StructCasts, OthersStay) {
  for (const char* text : {"B f() { return (B)0; }", "B f(int n) { return (B)n; }",
                           "struct C { float4 q; }; C f(A a) { return (C)a; }",
                           "struct C { float4 q; half2 v[3]; }; C f(A a) { return (C)a; }",
                           "B f(A a[2]) { return (B)a; }", "float f(A a) { return (float4)a.p; }"})
    EXPECT_EQ(after<copy_cast_structs>(kPair + text), kPair + text);
}

const std::string kMatrices =
    "float4x4 M, N[2]; float3x3 R, Q; float2x3 S; float3x2 T; float4x4 Get(); float x; float3 v; int2x2 I; ";

// The text that a statement becomes; the functions before it are looked at on the device.
std::string statement(const std::string& hlsl) {
  const std::string result = after<write_out_matrix_operators>(kMatrices + "void f() { " + hlsl + "; }");
  const std::string before = kMatrices + "void f() { ";
  const std::size_t at = result.find(before);
  std::string changed = result.substr(at + before.size(), result.size() - at - before.size() - 3);
  if (changed.back() == ' ') changed.pop_back();
  return changed;
}

TEST(MatrixOperators, ProductsAreCalls) {
  EXPECT_EQ(statement("R * Q"), "penumbra_times( R , Q )");
  EXPECT_EQ(statement("R * Q * R"), "penumbra_times( penumbra_times( R , Q ) , R )");
  EXPECT_EQ(statement("x / R * Q"), "penumbra_times( x / R , Q )");
  EXPECT_EQ(statement("x + -R * N[0] * Q"),
            "x + penumbra_times( penumbra_times( -R , (float3x3) N[0] ) , Q )");
  EXPECT_EQ(statement("transpose(R) * float3x3(v, v, v)"),
            "penumbra_times( transpose(R) , float3x3(v, v, v) )");
  EXPECT_EQ(statement("mul(v, R * Q)"), "mul(v, penumbra_times( R , Q ) )");
  EXPECT_EQ(statement("R *= Q"), "R = penumbra_times(R, Q )");
  EXPECT_EQ(statement("N[1] *= 2 * M"), "N[1] = penumbra_times(N[1], 2 * M )");
}

TEST(MatrixOperators, OverloadsFindWhatIsNotKnown) {
  EXPECT_EQ(statement("mul(R, Q) * R"), "penumbra_times( mul(R, Q) , R )");
  EXPECT_EQ(statement("R * Unknown(x)"), "penumbra_times( R , Unknown(x) )");
  EXPECT_EQ(statement("R * abs(Q)"), "penumbra_times( R , abs(Q) )");
  EXPECT_EQ(statement("R * 2 * Q"), "penumbra_times( R * 2 , Q )");
  EXPECT_EQ(statement("mul(R, Q) * (x * R)"), "penumbra_times( mul(R, Q) , (x * R) )");
  EXPECT_EQ(statement("(R + Q) * (float3x3)(M + M)"), "penumbra_times( (R + Q) , (float3x3)(M + M) )");
}

// The pass takes linear time: squares of these lengths would not end within the test's time.
TEST(MatrixOperators, ReadLongAndDeepProducts) {
  std::string deep = "R";
  std::string wide = "R";
  for (int i = 0; i < 100000; ++i) {
    deep = i < 5000 ? "(" + deep + ") * R" : deep;
    wide += " * R";
  }
  EXPECT_NE(statement(deep), deep);
  EXPECT_NE(statement(wide), wide);
}

TEST(MatrixOperators, TheLargerMatrixIsCast) {
  EXPECT_EQ(statement("(float3x3)M * N[1]"), "penumbra_times( (float3x3)M , (float3x3) N[1] )");
  EXPECT_EQ(statement("R + Get()"), "R + (float3x3) Get()");
  EXPECT_EQ(statement("M - R"), "(float3x3) M - R");
  EXPECT_EQ(statement("M / S"), "(float2x3) M / S");
  EXPECT_EQ(statement("M * R"), "penumbra_times( (float3x3) M , R )");
  EXPECT_EQ(statement("R + (float4x4)M"), "R + (float3x3) (float4x4)M");
}

TEST(MatrixOperators, OthersStay) {
  for (const char* text :
       {"R * 2", "2.0 * R", "R * x", "x * (float)R", "S + T", "mul(M, R)", "M[0] * R[0]", "M[0].xyz - x",
        "-R", "R *= 2", "R *= x", "v *= v", "sin(x) * cos(x)", "R * sin(x)", "mul(v, R) * mul(R, v)",
        "(x + R[0][0]) * (v.x + 1)", "(float3)x * M[0].xyz", "R + Q", "N[0][0] * x"})
    EXPECT_EQ(statement(text), text);
}

TEST(StaticInitialisers, AreWorkedOutWhereTheyAreRead) {
  EXPECT_EQ(after<work_out_static_initialisers>(
                "float g(float x) { return x; } static const float w[2] = { g(1), 2 }; "
                "float f(int i) { return w[i]; } float h() { return 1; }"),
            "float g(float x) { return x; } "
            "void set_w(out float to_w[2]) { const float w[2] = { g(1), 2 }; to_w = w; } "
            "float f(int i) { float w[2]; set_w(w); return w[i]; } float h() { return 1; }");
}

TEST(StaticInitialisers, ThoseThatReadOthersGoWithThem) {
  EXPECT_EQ(after<work_out_static_initialisers>(
                "float g() { return 1; } static const float a = g(); const static float b = a + 1; "
                "struct S { float f() { return b; } };"),
            "float g() { return 1; } void set_a(out float to_a) { const float a = g(); to_a = a; } "
            "void set_b(out float to_b) { float a; set_a(a); const float b = a + 1; to_b = b; } "
            "struct S { float f() { float b; set_b(b); return b; } };");
}

TEST(StaticInitialisers, OthersStay) {
  const std::string g = "float g(float x) { return x; } ";
  for (const char* text : {"static const float a = sqrt(2); float f() { return a; }",
                           "static float a = g(1); float f() { return a; }",
                           "static const float a[] = { g(1) }; float f() { return a[0]; }",
                           "static const float a = 1, b = 2; float f() { return a; }",
                           "float f() { const float a = g(1); return a; }"})
    EXPECT_EQ(after<work_out_static_initialisers>(g + text), g + text);
}

TEST(StaticInitialisers, NamesOfTheirOwnHideThem) {
  const std::string before = "float g() { return 1; } static const float a = g(); ";
  const std::string prepared =
      "float g() { return 1; } void set_a(out float to_a) { const float a = g(); to_a = a; } ";
  for (const char* text : {"float f(float a) { return a; }", "float f() { { float a = 1; return a; } }",
                           "struct S { float a; }; float f(S s) { return s.a; }"})
    EXPECT_EQ(after<work_out_static_initialisers>(before + text), prepared + text);
}

TEST(MissingReturns, OfTexturesAndSamplersGoWhereNothingCallsThem) {
  const auto run = after<return_from_empty_functions>;
  EXPECT_EQ(run("SamplerState f() { } Texture2D<float4> g(int i) { } float h();"), "float h();");
  const std::string called = "SamplerState f() { } float4 h(Texture2D t) { return t.Sample(f(), 0); }";
  EXPECT_EQ(run(called), called);
}

TEST(ArrayCasts, OfZeroAreMembersOfAZeroedStruct) {
  EXPECT_EQ(
      after<cast_zero_to_structs>("void f() { float3 a[4] = (float3[4])0; int b[2][N] = (int[2][N])0; } "
                                  "void g() { float3 a[4]; a = (float3[4])0.0; }"),
      "struct penumbra_zeroes0 { float3 value[4]; }; struct penumbra_zeroes1 { int value[2][N]; }; "
      "void f() { float3 a[4] = ((penumbra_zeroes0)0).value ; int b[2][N] = ((penumbra_zeroes1)0).value ; } "
      "void g() { float3 a[4]; a = ((penumbra_zeroes0)0).value ; }");
  for (const char* text :
       {"float f() { return (a[4]); }", "void f() { float a[2] = (float[2])b; }",
        "float f() { return (float)0; }", "float f() { return (a[1])-0; }", "void f() { (a[])0; }"})
    EXPECT_EQ(after<cast_zero_to_structs>(text), text);
}

}  // namespace
}  // namespace penumbra::preparation
