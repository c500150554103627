// Tests where glslang means something else than HLSL: operators and intrinsic functions run on the device,
// against answers by HLSL's rules (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-operators
// and -intrinsic-functions).
#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "fxc/fxc.h"
#include "preparation/executed.h"

namespace penumbra::preparation {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<float> outputs(const std::string& statements, std::vector<float> in, std::size_t count,
                           const std::string& before = "") {
  return run_prepared(
      {before + "[numthreads(1, 1, 1)] void Main() {\n" + statements + "}", std::move(in), {}, count});
}

// The remainder has the sign of the dividend, for integers and for floats.
TEST(ExecutedRemainders, TruncateForEverySign) {
  const std::string statements = R"(
    float x = In[0]; float y = In[1]; int i = int(x); int j = int(y);
    Out[0] = i % j; Out[1] = x % y; Out[2] = fmod(x, y);
    Out[3] = (int2(i, -i) % int2(j, -j)).y; Out[4] = (float3(x, -x, x) % y).y; Out[5] = fmod(float2(x, -x), y).y;
    int k = i; k %= j; Out[6] = k;
    float z = x; z %= y; Out[7] = z;
    float2x2 m = float2x2(x, -x, x, -x); Out[8] = (m % y)[0][1];)";
  for (const float x : {7.0F, -7.0F})
    for (const float y : {2.0F, -2.0F, 4.0F}) {
      const float r = std::fmod(x, y);
      EXPECT_THAT(outputs(statements, {x, y}, 9), ElementsAre(r, r, r, -r, -r, -r, r, r, -r))
          << x << " " << y;
    }
}

TEST(ExecutedRemainders, OfUnsignedNumbersUseAllBits) {
  EXPECT_THAT(
      outputs("uint u = 0xFFFFFFF0u + uint(In[0]); Out[0] = u % 7u; Out[1] = (u / 16u) % 5u;", {3.0F}, 2),
      ElementsAre(static_cast<float>(0xFFFFFFF3U % 7U), static_cast<float>((0xFFFFFFF3U / 16U) % 5U)));
}

TEST(ExecutedConstants, AreWorkedOutAsOnTheDevice) {
  const std::string statements = R"(
    const float2 low = float2(0, 0.5);
    Out[0] = fmod(-7.0, 2.0); Out[1] = -7.5 % 2.0; Out[2] = (-7) % 2; Out[3] = k;
    bool3 less = float3(1, 2, 3) < 2; Out[4] = less.x; Out[5] = less.y; Out[6] = less.z;
    Out[7] = any(low); Out[8] = all(float2(4, 0)); Out[9] = any((int2)4); Out[10] = dot(int2(1, 2), int2(3, 4));)";
  EXPECT_THAT(outputs(statements, {0}, 11, "static const float k = fmod(-5.5, 2);\n"),
              ElementsAre(-1, -1.5, -1, -1.5, 1, 0, 0, 1, 0, 1, 11));
}

TEST(ExecutedIntrinsics, SignGivesWholeNumbers) {
  const std::string statements = R"(
    uint u = 0x80000000u + uint(In[1]);
    Out[0] = sign(In[0]) / 2; Out[1] = sign(int(In[0])); Out[2] = sign(u); Out[3] = (sign(float2(In[0], In[1])) & 3).x;
    Out[4] = sign(In[0]) * 0.5;)";
  EXPECT_THAT(outputs(statements, {-7, 2}, 5), ElementsAre(0, -1, 1, 3, -0.5));
}

TEST(ExecutedIntrinsics, AbsAndMinusOfUnsignedNumbersAreUnsigned) {
  const std::string statements = R"(
    uint u = 0x80000005u + uint(In[0]);
    Out[0] = abs(u) == u; Out[1] = -(uint2(u, 8) / 2u) == uint2(0u - u / 2u, 0xFFFFFFFCu) ? 1 : 0;
    Out[2] = (-(uint3(1, 6, 19) / 2u) & 63u).y;)";
  const std::vector<float> out = outputs(statements, {2}, 3);
  EXPECT_EQ(out[0], 1);
  EXPECT_EQ(out[2], 61);
}

TEST(ExecutedStatics, AreZeroWithoutAnInitialiser) {
  const std::string before =
      "struct S { float2 a; int b[2]; }; static float f; static S s[2]; static float2x2 m;\n"
      "float Count() { static float n; n += 1; return n; }\n";
  EXPECT_THAT(
      outputs(
          "int i = int(In[0]); f += 2; Out[0] = f; Out[1] = s[i].b[i]; Out[2] = s[i].a.y; Out[3] = m[i][i]; "
          "Count(); Out[4] = Count();",
          {1}, 5, before),
      ElementsAre(2, 0, 0, 0, 2));
}

// The result is 1, n.l, n.h to the power of m where neither is negative, and 1.
TEST(ExecutedIntrinsics, LitRaisesToAPower) {
  const std::string statements =
      "float4 l = lit(In[0], In[1], In[2]); "
      "Out[0] = l.x; Out[1] = l.y; Out[2] = l.z; Out[3] = l.w;";
  EXPECT_THAT(outputs(statements, {0.25F, 0.5F, 3}, 4),
              ElementsAre(1, 0.25, testing::FloatNear(0.125F, 1e-6F), 1));
  EXPECT_THAT(outputs(statements, {-1, 0.5F, 3}, 4), ElementsAre(1, 0, 0, 1));
  EXPECT_THAT(outputs(statements, {1, -0.5F, 3}, 4), ElementsAre(1, 1, 0, 1));
}

TEST(ExecutedMatrices, OperatorsTakeTheirElements) {
  const std::string statements = R"(
    float2x2 m = float2x2(In[0], In[1], In[2], In[3]), n = float2x2(1, 2, 4, 8); float s = In[1]; int i = int(s);
    Out[0] = (-m)[1][0]; Out[1] = (m + n)[0][1]; Out[2] = (s - m)[1][1]; Out[3] = (m / n)[1][0];
    Out[4] = (m / s)[0][0]; Out[5] = (s / n)[1][1]; Out[6] = (m % n)[0][1]; Out[7] = (s > 0 ? m : n)[i - 1][1];
    Out[8] = (m * s)[1][1]; m /= 4; m %= 2; m -= 1; m++; Out[9] = m[1][1];)";
  EXPECT_THAT(outputs(statements, {-1, 2, 3, 10}, 10),
              ElementsAre(-3, 4, -8, 0.75F, -0.5F, 0.25F, 0, 10, 20, 0.5F));
}

// glslang would multiply as mul() does, and crash at others; FXC gives them their meaning.
TEST(ExecutedMatrices, WhatGlslangDoesNotDoByElementsIsAnError) {
  const auto execution = [](const std::string& statements) {
    return Execution{
        "float2x2 Get(float2x2 m) { return m; } float3x3 Get(float3x3 m) { return m; }\n"
        "[numthreads(1, 1, 1)] void Main() { float2x2 m = float2x2(In[0], In[1], In[2], In[3]);\n"
        "float2x2 n = m + 1; int2x2 w = int2x2(9, 8, 7, 6);\n" +
            statements + "}",
        {1, 2, -3, 10},
        {},
        1};
  };
  struct Case {
    const char* statements;
    float answer;
    const char* told;
  };
  for (const Case& one :
       {Case{"Out[0] = (m * n)[0][1];", 6, "'*' of two matrices"},
        Case{"Out[0] = (Get(m) * Get(n))[1][0];", 6, "'*' of two matrices"},
        Case{"n *= m; Out[0] = n[1][1];", 110, "'*' of two matrices"},
        Case{"Out[0] = abs(m)[1][0];", 3, "functions"},
        Case{"Out[0] = lerp(m, n, 0.5)[0][1];", 2.5F, "functions"},
        Case{"Out[0] = max(m, n)[1][1];", 11, "functions"},
        Case{"Out[0] = mad(m, n, m)[0][1];", 8, "functions"},
        Case{"Out[0] = fmod(n, m)[1][1];", 1, "functions"},
        Case{"Out[0] = ldexp(m, 2)[0][1];", 8, "functions"},
        Case{"Out[0] = any(m) + all(m);", 2, "functions"}, Case{"Out[0] = m == m ? 1 : 0;", 1, "comparisons"},
        Case{"bool2x2 b = m; Out[0] = b[0][0];", 1, "bools"},
        Case{"float2x2 whole; Out[0] = modf(m / 4, whole)[0][1];", 0.5F, "functions"},
        Case{"w /= 2; Out[0] = w[0][0];", 4, "whole numbers"},
        Case{"w++; Out[0] = w[0][0];", 10, "whole numbers"},
        Case{"Out[0] = (~w)[0][0];", -10, "whole numbers"},
        Case{"Out[0] = (w + 1)[int(In[0])][1];", 7, "whole numbers"}}) {
    EXPECT_THAT([&] { run_prepared(execution(one.statements)); },
                ThrowsMessage<std::runtime_error>(
                    AllOf(HasSubstr(":5: error: not supported here: "), HasSubstr(one.told))))
        << one.statements;
    if (!fxc::find_fxc().found) continue;
    EXPECT_THAT(run_by_fxc(execution(one.statements)), ElementsAre(testing::FloatNear(one.answer, 1e-5F)))
        << one.statements;
  }
  EXPECT_THAT([&] { run_prepared(execution("float2 v = In[0]; v = v * m; Out[0] = v.x;")); },
              ThrowsMessage<std::runtime_error>(HasSubstr("of a vector and a matrix")));
}

// A global constant without static is a uniform, and holds what its buffer does.
TEST(ExecutedConstants, WithoutStaticAreUniforms) {
  const Execution execution{
      "const float k = 5; const int n = 2; [numthreads(1, 1, 1)] void Main() { float a[n]; a[0] = k; a[1] = "
      "7; "
      "Out[0] = a[0]; Out[1] = a[1]; Out[2] = asfloat(n); }",
      {0},
      {{"$Global", {11, 13}}},
      3};
  EXPECT_THAT(run_prepared(execution), ElementsAre(11, 7, 13));
}

TEST(ExecutedConstants, AreWorkedOutWhenTheShaderStarts) {
  EXPECT_THAT(
      run_prepared(
          {"cbuffer C { float u; }; static const float s = u * 2; [numthreads(1, 1, 1)] void Main() { "
           "u = 100; Out[0] = s; Out[1] = u; }",
           {0},
           {{"C", {3}}},
           2}),
      ElementsAre(6, 100));
}

// The functions differ in half and float alone, and the one that the arguments choose is kept.
TEST(ExecutedTwins, TheOneThatIsCalledIsKept) {
  const std::string twins =
      "float f(half x) { return 1; } float f(float x) { return 2; } struct V { half2 c; };\n";
  const auto run = [&](const std::string& statements) { return outputs(statements, {4}, 1, twins); };
  EXPECT_THAT(run("half h = In[0]; Out[0] = f(h);"), ElementsAre(1));
  EXPECT_THAT(run("V v; v.c = In[0]; Out[0] = f(v.c.x * 2);"), ElementsAre(1));
  EXPECT_THAT(run("Out[0] = f((half)In[0]);"), ElementsAre(1));
  EXPECT_THAT(run("Out[0] = f(In[0]);"), ElementsAre(2));
  EXPECT_THAT(run("half h = 1; Out[0] = f(h * In[0]);"), ElementsAre(2));
  // This compiles with a warning.
  EXPECT_THAT(run("half h = In[0]; Out[0] = f(h) + f(In[0]);"), ElementsAre(4));
}

}  // namespace
}  // namespace penumbra::preparation
