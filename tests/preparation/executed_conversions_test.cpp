// Runs converted structs, matrices and constants on the device, against answers worked out here.
#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "fxc/at_hand.h"
#include "preparation/executed.h"

namespace penumbra::preparation {
namespace {

using testing::ElementsAre;
using testing::FloatNear;

TEST(ExecutedArrayCasts, AreZeroEverywhere) {
  PENUMBRA_NEEDS_FXC();
  const Execution execution{R"(struct S { float4x4 m; int n; };
[numthreads(1, 1, 1)] void Main() {
    int i = int(In[0]);
    float4x4 m[2] = (float4x4[2])0;
    S s[3] = (S[3])0;
    float2 v[2][2];
    v[i][1] = 5;
    Out[0] = v[i][1].y;
    v = (float2[2][2])0;
    float sum = 0;
    for (int k = 0; k < 16; ++k) sum += abs(m[i][k / 4][k % 4]) + abs(s[i + 1].m[k / 4][k % 4]);
    Out[1] = sum; Out[2] = s[i + 1].n; Out[3] = v[i][1].y; })",
                            {1},
                            {},
                            4};
  EXPECT_THAT(run_by_fxc(execution), ElementsAre(5, 0, 0, 0));
}

TEST(ExecutedStructCasts, CopyEveryMember) {
  PENUMBRA_NEEDS_FXC();
  const Execution execution{R"(struct A { float4 p : POSITION; float2 u[2] : UV; uint id : SV_VertexID; };
struct B { float4 q : POSITION; float2 v[2] : UV; uint n : TEXCOORD2; };
A Read() { A a; a.p = float4(In[0], In[1], In[2], In[3]); a.u[0] = In[4]; a.u[1] = float2(In[5], In[6]); a.id = 9;
  return a; }
[numthreads(1, 1, 1)] void Main() {
    A a = (A)Read();
    a.p.x += 1;
    B b = (B)a;
    Out[0] = b.q.x; Out[1] = b.q.w; Out[2] = b.v[0].y; Out[3] = b.v[1].x; Out[4] = b.v[1].y; Out[5] = b.n; })",
                            {1, 2, 3, 4, 5, 6, 7},
                            {},
                            6};
  EXPECT_THAT(run_by_fxc(execution), ElementsAre(2, 4, 5, 6, 7, 9));
}

const std::string kMatrix = R"(float4x4 Read() {
    float4x4 m; for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = In[i]; return m; }
)";

std::vector<float> from_zero_to_fifteen() {
  std::vector<float> values(16);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
  return values;
}

TEST(ExecutedMatrixOperators, KeepTheUpperLeftElementsOfTheLarger) {
  PENUMBRA_NEEDS_FXC();
  const Execution execution{kMatrix + R"([numthreads(1, 1, 1)] void Main() {
    float4x4 m = Read();
    float3x3 product = (float3x3)m * Read();
    float2x3 difference = float2x3(1, 2, 3, 4, 5, 6) - m;
    Out[0] = product[0][2]; Out[1] = product[2][1]; Out[2] = difference[0][1]; Out[3] = difference[1][2]; })",
                            from_zero_to_fifteen(),
                            {},
                            4};
  EXPECT_THAT(run_by_fxc(execution), ElementsAre(4, 81, 1, 0));
}

TEST(ExecutedMatrixOperators, MultiplyElementByElement) {
  PENUMBRA_NEEDS_FXC();
  const Execution execution{kMatrix + R"([numthreads(1, 1, 1)] void Main() {
    float4x4 m = Read();
    float4x4 n = m + m;
    float4x4 product = m * n;
    float4x4 unknown = mul(m, n) * (m * abs(In[2]));
    float2x3 s = float2x3(1, 2, 3, 4, 5, 6);
    s *= s * 2;
    n *= m;
    float4x4 quotient = 60 / (m + 1) * m;
    Out[0] = product[0][3]; Out[1] = product[2][1]; Out[2] = unknown[1][2]; Out[3] = s[1][2]; Out[4] = s[0][1];
    Out[5] = n[3][2]; Out[6] = quotient[0][2]; })",
                            from_zero_to_fifteen(),
                            {},
                            7};
  // mul(m, 2m)[1][2] = 2 (4 * 2 + 5 * 6 + 6 * 10 + 7 * 14) = 392, times 6 * 2.
  EXPECT_THAT(run_by_fxc(execution), ElementsAre(18, 162, 4704, 72, 8, 392, 40));
}

TEST(ExecutedSwizzleArguments, AreAssignedBack) {
  PENUMBRA_NEEDS_FXC();
  const Execution execution{kMatrix + R"(void Double(inout float3 v) { v *= 2; }
void Set(float2 a, out float2 v) { v = a + 100; }
[numthreads(1, 1, 1)] void Main() {
    float4x4 m = Read();
    if (In[1] > 0) Double(m._14_24_34);
    Set(m._11_12, m._m30_m31);
    Out[0] = m[0][3]; Out[1] = m[1][3]; Out[2] = m[2][3]; Out[3] = m[3][3]; Out[4] = m[3][0]; Out[5] = m[3][1]; })",
                            from_zero_to_fifteen(),
                            {},
                            6};
  EXPECT_THAT(run_by_fxc(execution), ElementsAre(6, 14, 22, 15, 100, 101));
}

TEST(ExecutedStaticInitialisers, HoldWhatTheirFunctionsReturn) {
  PENUMBRA_NEEDS_FXC();
  const Execution execution{R"(float Gauss(float x) { return exp(-x * x); }
float Other() { return 3; }
static const float weights[3] = { Gauss(0), Gauss(0.5), Gauss(1) };
static const float total = weights[0] + weights[1] + weights[2] + Other();
float Weight(int i) { return weights[i]; }
[numthreads(1, 1, 1)] void Main() {
    Out[0] = Weight(int(In[0])); Out[1] = weights[2]; Out[2] = total; })",
                            {1},
                            {},
                            3};
  const float half = std::exp(-0.25F);
  const float one = std::exp(-1.0F);
  EXPECT_THAT(run_by_fxc(execution),
              ElementsAre(FloatNear(half, 1e-6F), FloatNear(one, 1e-6F), FloatNear(4 + half + one, 1e-5F)));
}

TEST(ExecutedPrecisionMatrices, MultiplyAsFloats) {
  const Execution execution{R"([numthreads(1, 1, 1)] void Main() {
    min16float2x2 m = min16float2x2(In[0], In[1], In[2], In[3]);
    float2 v = mul(m, float2(1, 10));
    Out[0] = v.x; Out[1] = v.y; })",
                            {1, 2, 3, 4},
                            {},
                            2};
  EXPECT_THAT(run_prepared(execution), ElementsAre(21, 43));
}

// Conditions are scalars after glslang; those of vectors are as they always were.
TEST(ExecutedConditions, OfScalarsAreTheScalars) {
  const Execution execution{R"([numthreads(1, 1, 1)] void Main() {
    Out[0] = any(In[0]); Out[1] = any(In[1]); Out[2] = all(In[0] > 1); Out[3] = all(In[1] > 1);
    Out[4] = any(float2(In[0], In[1])); Out[5] = all(float2(In[0], In[1])); Out[6] = any(int(In[1])); })",
                            {0, 2},
                            {},
                            7};
  EXPECT_THAT(run_prepared(execution), ElementsAre(0, 1, 0, 1, 1, 0, 1));
  EXPECT_EQ(run_unprepared(execution), run_prepared(execution));
}

}  // namespace
}  // namespace penumbra::preparation
