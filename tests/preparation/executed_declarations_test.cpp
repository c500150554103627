// Runs declarations, initialisers and expressions that Unity's compilers take and glslang does not, on the
// device and by way of what is emitted for other APIs, against answers worked out here by HLSL's rules.
#include <gmock/gmock.h>

#include "fxc/at_hand.h"
#include "preparation/executed.h"

namespace penumbra::preparation {
namespace {

using shaders::Target;
using testing::ElementsAreArray;

const std::string kMain = "[numthreads(1, 1, 1)] void Main() ";

void expect_prepared(const Execution& execution, const std::vector<float>& answer) {
  EXPECT_THAT(run_prepared(execution), ElementsAreArray(answer));
  for (const Target target : {Target::essl310, Target::glsl450, Target::hlsl50})
    EXPECT_THAT(run_through(execution, target), ElementsAreArray(answer)) << shaders::target_name(target);
}

// glslang refuses the shader, and it is right from FXC's bytecode.
void expect_from_bytecode(const Execution& execution, const std::vector<float>& answer) {
  EXPECT_THROW(run_prepared(execution), std::runtime_error);
  EXPECT_THAT(run_by_fxc(execution), ElementsAreArray(answer));
  for (const Target target : {Target::essl310, Target::glsl450, Target::hlsl50})
    EXPECT_THAT(run_by_fxc_through(execution, target), ElementsAreArray(answer))
        << shaders::target_name(target);
}

// The shader is refused without the stage, and right with it.
void expect_only_prepared(const Execution& execution, const std::vector<float>& answer) {
  EXPECT_THROW(run_unprepared(execution), std::runtime_error);
  expect_prepared(execution, answer);
}

TEST(ExecutedPrototypes, MayNameTheEntryPoint) {
  PENUMBRA_NEEDS_FXC();
  expect_from_bytecode({"[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID);\n"
                        "[numthreads(1, 1, 1)] void Main(uint3 id : SV_DispatchThreadID) { Out[id.x] = 5; }",
                        {0},
                        {},
                        1},
                       {5});
}

TEST(ExecutedCharacters, AreTheirCodes) {
  expect_only_prepared({R"(#define LAST(c) (c)
static const uint text[] = { 'N', 'o', '\n', '\'', '\\', '"', ' ', '\x41', '\101', '\0' };
)" + kMain + "{ for (int i = 0; i < 10; ++i) Out[i] = text[i + int(In[0])]; Out[10] = LAST('c') - 'a'; }",
                        {0},
                        {},
                        11},
                       {78, 111, 10, 39, 92, 34, 32, 65, 65, 0, 2});
}

TEST(ExecutedStorageOrder, ConstStaticIsStaticConst) {
  expect_only_prepared(
      {"const static uint N = 4;\nstatic const uint M = N * 2;\nstatic float table[N];\n"
       "groupshared float scratch[M];\n" +
           kMain +
           "{ float local[N]; local[3] = In[0]; table[2] = local[3]; scratch[7] = table[2] + N;\n"
           "  Out[0] = scratch[7]; Out[1] = M; }",
       {3},
       {},
       2},
      {7, 8});
}

TEST(ExecutedLoopVariables, LiveOnBehindTheirLoop) {
  PENUMBRA_NEEDS_FXC();
  expect_from_bytecode({kMain + R"({
    float s = 0;
    for (int i = 0; i < 4; ++i) { if (In[i] > 2) break; s += In[i]; }
    Out[0] = i;
    [unroll] for (int j = 0, k = 5; j < 2; ++j) s += j;
    Out[1] = j + k;
    for (i = 7; i < 9; ++i) s += 1;
    Out[2] = i;
    for (int i = 0; i < 3; i++) { for (int i = 0; i < 2; ++i) s += 1; }
    Out[3] = i; Out[4] = s;
    { for (int i = 0; i < 6; ++i) s += 1; Out[5] = i; }
    Out[6] = i;
    int n = 40;
    for (int n = 0; n < 3; ++n) s += 1;
    Out[7] = n; })",
                        {1, 2, 3, 4},
                        {},
                        8},
                       {2, 7, 9, 3, 12, 6, 3, 3});
}

TEST(ExecutedStructInitialisers, FillTheNumbersInTheirOrder) {
  PENUMBRA_NEEDS_FXC();
  expect_from_bytecode({R"(struct A { float3 p; float q; };
struct B { A a; float r[2]; };
struct C { float2 u; float2x2 m; int n; };
static const A g[2] = { 1, 2, 3, 4, { float3(5, 6, 7), 8 } };
A Zero() { A a = { 0, 0, 0, 9 }; return a; }
)" + kMain + R"({
    A a = { In[0], 2, 3, 4 };
    B b = { a, 5, 6 };
    A c = { In[0].xxx, 1 };
    B d = { { float3(1, 2, 3), 4 }, { 5, 6 } };
    float4 v = float4(10, 11, 12, In[0]);
    A e = { v };
    C f = { v, 13, 14, -15 };
    A h[2] = { { a.p.xy, a.p.z, 7 }, v };
    Out[0] = a.p.x; Out[1] = b.r[1]; Out[2] = b.a.q; Out[3] = c.p.z; Out[4] = d.r[0]; Out[5] = e.q;
    Out[6] = f.m[0][1]; Out[7] = f.m[1][0]; Out[8] = f.n; Out[9] = h[0].p.z; Out[10] = h[1].p.y;
    Out[11] = g[1].p.z; Out[12] = g[0].q; Out[13] = Zero().q; })",
                        {21},
                        {},
                        14},
                       {21, 6, 4, 21, 5, 21, 21, 13, -15, 3, 11, 7, 4, 9});
}

TEST(ExecutedRowMatrices, AreVectors) {
  PENUMBRA_NEEDS_FXC();
  expect_from_bytecode({R"(float1x3 Row(float x) { return float1x3(1, 2, x); }
)" + kMain + R"({
    float1x3 m = Row(In[0]);
    float3x1 n = float3x1(In[0], 2, 3);
    float4x1 c = { 1, 2, 3, 4 };
    float3x3 t = float3x3(1, 2, 3, 4, 5, 6, 7, 8, 9);
    float1x1 o = float1x1(In[0]);
    m[0][1] += 10;
    c._m20 = 8;
    Out[0] = m[0].z; Out[1] = m._m02; Out[2] = n[1][0]; Out[3] = mul(m, n); Out[4] = o[0][0];
    Out[5] = c._31; float1x3 p = mul(m, t); Out[6] = p._m01; n = mul(t, n); Out[7] = n._21; Out[8] = Row(4)[0][2]; Out[9] = n[2]; })",
                        {5},
                        {},
                        10},
                       {5, 5, 2, 44, 5, 8, 102, 48, 4, 78});
}

TEST(ExecutedUniformWrites, ReachMembersOfStructs) {
  expect_only_prepared({R"(struct S { float3 p; float q; };
cbuffer K { S s; S t[2]; float4 u; };
void Set(out float x) { x = 50; }
)" + kMain + R"({
    s.q = In[0]; t[1].p.x += 2; t[0].p.y = 1; u.x = 5; Set(s.p.z);
    Out[0] = s.q + s.p.x; Out[1] = t[1].p.x + t[1].p.y; Out[2] = u.x + u.y; Out[3] = s.p.z; })",
                        {9},
                        {{"K", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}}},
                        4},
                       {10, 21, 19, 50});
}

TEST(ExecutedNarrowerParameters, TakeTheFirstComponents) {
  expect_only_prepared({R"(float One(float x) { return x * 2; }
float Two(float2 v, float3 w) { return v.x * 10 + v.y + w.z * 100; }
float Wide(float x) { return x; }
float Wide(float4 x) { return x.w; }
void Set(float2 v, out float3 w) { w = v.xyx; }
)" + kMain + R"({
    float4 v = float4(1, 2, 3, In[0]);
    float4x4 m = { v, v * 2, v * 3, v * 4 };
    float3 w;
    Set(v, w);
    Out[0] = One(v); Out[1] = Two(v, v); Out[2] = Wide(v); Out[3] = w.z; Out[4] = One(mul(m, float4(1, 0, 0, 1)));
    Out[5] = One(v.w); Out[6] = Two(saturate(v), abs(exp2(v))); })",
                        {7},
                        {},
                        7},
                       {2, 312, 7, 1, 16, 14, 811});
}

TEST(ExecutedTypeSemantics, MayBeCalledLikeATypeInHlsl) {
  PENUMBRA_NEEDS_FXC();
  expect_from_bytecode({"struct V { float3 a : float3; float4x4 m : float4x4; };\n" + kMain +
                            "{ V v = (V)0; v.a = In[0]; Out[0] = v.a.y > 1 ? v.a.z : v.m[0][0]; }",
                        {3},
                        {},
                        1},
                       {3});
}

TEST(ExecutedOwnMethods, OfEveryDeclaratorOfSharedVariables) {
  PENUMBRA_NEEDS_FXC();
  expect_from_bytecode(
      {"struct S { float a; void Set(float x) { a = x; } float Twice() { return 2 * a; } };\n"
       "groupshared S g, h;\n" +
           kMain + "{ g.Set(In[0]); h.Set(5); Out[0] = g.Twice(); Out[1] = h.Twice(); }",
       {3},
       {},
       2},
      {6, 10});
}

TEST(ExecutedOwnMethods, ConvertTheirArguments) {
  PENUMBRA_NEEDS_FXC();
  expect_from_bytecode(
      {"struct S { float a; float F(float x) { a += x; return a; } float G() { return F(1) + F(true); } "
       "};\n" +
           kMain + "{ S s; s.a = In[0]; Out[0] = s.G(); Out[1] = s.a; }",
       {3},
       {},
       2},
      {9, 5});
}

TEST(ExecutedSwitches, OfAFloatTakeItsWholePart) {
  PENUMBRA_NEEDS_FXC();
  const std::string cases = "{ case 0: return 10; case 1: return 20; default: return 30; } ";
  expect_from_bytecode(
      {"float F(half h) { switch (h) " + cases + "}\nfloat G(float f) { switch (f * 2.0) " + cases +
           "}\nfloat H(float f) { switch ((int)f) " + cases + "}\n" + kMain +
           "{ for (int i = 0; i < 3; ++i) Out[i] = F(In[i]) + G(In[i]) / 10 + H(In[i]) / 100; }",
       {0.5F, 1.75F, -0.5F},
       {},
       3},
      {10 + 2 + 0.1F, 20 + 3 + 0.2F, 10 + 3 + 0.1F});
}

}  // namespace
}  // namespace penumbra::preparation
