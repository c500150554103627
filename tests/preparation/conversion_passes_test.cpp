// Tests operators between matrices and missing returns: what is put there, and what must stay.
#include <gmock/gmock.h>

#include "preparation/after_pass.h"
#include "preparation/passes.h"

namespace penumbra::preparation {
namespace {

const std::string kPair =
    "struct A { float4 p : POSITION; half2 u[2] : A; }; struct B { float4 q : B; half2 v[2]; }; ";

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

TEST(MissingReturns, OfTexturesAndSamplersGoWhereNothingCallsThem) {
  const auto run = after<return_from_empty_functions>;
  EXPECT_EQ(run("SamplerState f() { } Texture2D<float4> g(int i) { } float h();"), "float h();");
  const std::string called = "SamplerState f() { } float4 h(Texture2D t) { return t.Sample(f(), 0); }";
  EXPECT_EQ(run(called), called);
}

}  // namespace
}  // namespace penumbra::preparation
