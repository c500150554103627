// Runs the rewritten expressions on the device, against answers worked out here.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <random>

#include "fxc/at_hand.h"
#include "preparation/executed.h"

namespace penumbra::preparation {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

// The matrix is the row-major 4x4 of In[0..15].
const std::string kGivenMatrix =
    "float4x4 Read() { float4x4 m; for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = In[i]; return m; }\n";

std::vector<float> sixteen() {
  std::vector<float> values(16);
  std::mt19937 random(11);
  for (float& value : values) value = static_cast<float>(random() % 1000) / 8.0F;
  return values;
}

float element(const std::vector<float>& m, int row, int column) {
  return m[static_cast<std::size_t>(4 * row + column)];
}

TEST(ExecutedIntegerProducts, OfMatricesAndVectors) {
  PENUMBRA_NEEDS_FXC();
  const Execution execution{R"([numthreads(1, 1, 1)] void Main() {
    int k = (int)In[0];
    int2x2 a = { k, 2, 3, -4 };
    uint3x3 b = { 1, 2, 3, 4, 5, 6, 7, 8, 9 };
    int2x3 c = { 1, 2, 3, 4, 5, 6 };
    int2 r = mul(a, int2(5, 6)), q = mul(int2(5, 6), a);
    int2x2 m = mul(a, a);
    uint3 u = mul(b, uint3(1, 10, 100));
    int3 w = mul(mul(a, c)[0].xy, c);
    Out[0] = r.x; Out[1] = r.y; Out[2] = q.x; Out[3] = q.y;
    Out[4] = m[0][0]; Out[5] = m[0][1]; Out[6] = m[1][0]; Out[7] = m[1][1];
    Out[8] = u.x; Out[9] = u.z; Out[10] = w.x; Out[11] = w.z; })",
                            {1.0F},
                            {},
                            12};
  // a = 1 2 / 3 -4; a a = 7 -6 / -9 22; a c = 9 12 15 / -13 -14 -15; (9, 12) c = 57, 78, 99.
  EXPECT_THAT(run_by_fxc(execution), ElementsAre(17.0F, -9.0F, 23.0F, -14.0F, 7.0F, -6.0F, -9.0F, 22.0F,
                                                 321.0F, 987.0F, 57.0F, 99.0F));
}

TEST(ExecutedMatrixSwizzles, ReadsEveryElementInItsOrder) {
  const std::vector<float> m = sixteen();
  const Execution execution{kGivenMatrix + R"([numthreads(1, 1, 1)] void Main() {
    float4x4 m = Read();
    float3 a = m._14_24_34;
    float4 b = Read()._m33_m00_m21_m00 * 2.0;
    Out[0] = a.x; Out[1] = a.y; Out[2] = a.z;
    Out[3] = b.x; Out[4] = b.y; Out[5] = b.z; Out[6] = b.w;
    Out[7] = m._m01_m02.y + m._m12; })",
                            m};
  EXPECT_THAT(run_prepared(execution),
              ElementsAre(element(m, 0, 3), element(m, 1, 3), element(m, 2, 3), 2 * element(m, 3, 3),
                          2 * element(m, 0, 0), 2 * element(m, 2, 1), 2 * element(m, 0, 0),
                          element(m, 0, 2) + element(m, 1, 2)));
}

TEST(ExecutedMatrixSwizzles, ReadsMatricesThatAreNotSquareAndWholeNumbers) {
  const Execution execution{R"(struct S { float2x3 m[2]; };
[numthreads(1, 1, 1)] void Main() {
    S s; s.m[0] = float2x3(1, 2, 3, 4, 5, 6); s.m[1] = 10 * s.m[0];
    int i = 1;
    float2 a = s.m[i]._13_21;
    int2x2 n = int2x2(16777217, 2, 3, 4);
    int2 b = n._m00_m11;
    Out[0] = a.x; Out[1] = a.y; Out[2] = b.x - 16777216; Out[3] = b.y; })",
                            {0.0F},
                            {},
                            4};
  EXPECT_THAT(run_prepared(execution), ElementsAre(30.0F, 40.0F, 1.0F, 4.0F));
}

TEST(ExecutedMatrixSwizzles, AssignsElementByElement) {
  std::vector<float> expected = sixteen();
  const Execution execution{kGivenMatrix + R"(struct S { float4x4 m; };
[numthreads(1, 1, 1)] void Main() {
    S s; s.m = Read();
    s.m._11_22 = s.m._22_11;
    s.m._m30_m31_m32 += float3(1, 2, 3);
    if (In[0] >= 0) s.m._m03_m13 *= 2;
    s.m._24_34_44 = 7;
    for (int i = 0; i < 16; ++i) Out[i] = s.m[i / 4][i % 4]; })",
                            expected,
                            {},
                            16};
  std::swap(expected[0], expected[5]);
  for (std::size_t i = 0; i < 3; ++i) expected[12 + i] += static_cast<float>(i + 1);
  expected[3] *= 2;
  expected[7] = expected[11] = expected[15] = 7;
  EXPECT_THAT(run_prepared(execution), ElementsAreArray(expected));
}

TEST(ExecutedMatrixSwizzles, SingleElementsAreAsTheyWere) {
  const Execution execution{kGivenMatrix + R"([numthreads(1, 1, 1)] void Main() {
    float4x4 m = Read(); m._m01 += 3; m._44 = m._m10;
    for (int i = 0; i < 16; ++i) Out[i] = m[i / 4][i % 4]; })",
                            sixteen(),
                            {},
                            16};
  EXPECT_EQ(run_prepared(execution), run_unprepared(execution));
}

TEST(ExecutedUniformWrites, ChangeTheInvocationsCopy) {
  const Execution execution{R"(cbuffer C { float4 a; float b; float c; float d[2]; };
void Twice(inout float x) { x *= 2; }
float Sum() { return a.x + a.y + a.z + a.w; }
[numthreads(1, 1, 1)] void Main() {
    a.yz = In[0];
    Twice(b);
    c++;
    d[1] -= 1;
    { float d = 100; d += 1; Out[5] = d; }
    Out[0] = Sum(); Out[1] = b; Out[2] = c; Out[4] = a.w; })",
                            {5.0F},
                            {{"C", {1, 2, 3, 4, 6, 7, 0, 0, 8, 0, 0, 0, 9, 0, 0, 0}}},
                            6};
  const std::vector<float> out = run_prepared(execution);
  EXPECT_EQ(out[0], 1.0F + 5.0F + 5.0F + 4.0F);
  EXPECT_EQ(out[1], 12.0F);  // without the pass it stays 6
  EXPECT_EQ(out[2], 8.0F);
  EXPECT_EQ(out[4], 4.0F);
  EXPECT_EQ(out[5], 101.0F);
}

TEST(ExecutedIntrinsicCalls, MadAndLdexpOfEveryType) {
  const Execution execution{R"([numthreads(1, 1, 1)] void Main() {
    int2 i = mad(int2(2, 3), 4, int(In[0]));
    uint u = mad(2u, 3u, mad(1u, 1u, 1u));
    float4 f = mad(float4(1, 2, 3, 4), In[0], 0.5);
    Out[0] = i.x; Out[1] = i.y; Out[2] = u; Out[3] = f.w;
    Out[4] = ldexp(3.0, 2.0); Out[5] = ldexp(float2(1, In[0]), -1).y; })",
                            {5.0F},
                            {},
                            6};
  EXPECT_THAT(run_prepared(execution), ElementsAre(13.0F, 17.0F, 8.0F, 20.5F, 12.0F, 2.5F));
}

TEST(ExecutedUniformParameters, ArgumentsAreConverted) {
  const Execution execution{R"(float F(float a, uniform float b, uniform in int c) { return a * b + c; }
[numthreads(1, 1, 1)] void Main() { Out[0] = F(In[0], 2, 1.5); Out[1] = F(1, In[0], 2u); })",
                            {3.0F},
                            {},
                            2};
  EXPECT_THAT(run_prepared(execution), ElementsAre(7.0F, 5.0F));
}

TEST(ExecutedIntrinsicCalls, CompareStoreChangesWhatIsEqual) {
  PENUMBRA_NEEDS_FXC();
  const Execution execution{R"(groupshared int S[2]; groupshared uint U;
[numthreads(1, 1, 1)] void Main() {
    S[0] = 5; S[1] = -6; U = 7;
    InterlockedCompareStore(S[0], 5, 8);
    if (In[0] > 0) InterlockedCompareStore(S[1], -7, 9);
    else InterlockedCompareStore(S[1], 1, 2);
    InterlockedCompareStore(U, 7, uint(In[0]));
    Out[0] = S[0]; Out[1] = S[1]; Out[2] = U; })",
                            {3.0F},
                            {},
                            3};
  EXPECT_THAT(run_by_fxc(execution), ElementsAre(8.0F, -6.0F, 3.0F));
}

TEST(ExecutedFlatInitialisers, FillInOrder) {
  PENUMBRA_NEEDS_FXC();
  const Execution execution{R"(static const float2 pairs[2] = { 1, 2, 3, 4 };
[numthreads(1, 1, 1)] void Main() {
    int i = int(In[0]);
    float table[2][3] = { 1, 2, 3, 4, 5, 6, };
    float2x2 matrices[2] = { 1, 2, 3, 4, 5, 6, 7, In[0] + 7 };
    Out[0] = pairs[i].x; Out[1] = pairs[i].y; Out[2] = table[i][0]; Out[3] = table[i][2];
    Out[4] = matrices[i][0][1]; Out[5] = matrices[i][1][1]; })",
                            {1.0F},
                            {},
                            6};
  EXPECT_THAT(run_by_fxc(execution), ElementsAre(3.0F, 4.0F, 4.0F, 6.0F, 6.0F, 8.0F));
}

}  // namespace
}  // namespace penumbra::preparation
