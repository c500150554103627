// Tests where glslang means something else than HLSL: operators and intrinsic functions run on the device,
// against answers by HLSL's rules (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-operators
// and -intrinsic-functions).
#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "preparation/executed.h"

namespace penumbra::preparation {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
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
    float2x2 m = float2x2(x, -x, x, -x); Out[8] = (m % y)[0][1]; Out[9] = fmod(m, y)[1][0];)";
  for (const float x : {7.0F, -7.0F})
    for (const float y : {2.0F, -2.0F, 4.0F}) {
      const float r = std::fmod(x, y);
      EXPECT_THAT(outputs(statements, {x, y}, 10), ElementsAre(r, r, r, -r, -r, -r, r, r, -r, r))
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
    Out[7] = any(low); Out[8] = all(float2(4, 0)); Out[9] = any((int2)4); Out[10] = dot(int2(1, 2), int2(3, 4));
    Out[11] = lerp(float2x2(1, 2, 3, 4), float2x2(5, 6, 7, 8), float2x2(0, 0.5, 1, 2))[1][1];)";
  EXPECT_THAT(outputs(statements, {0}, 12, "static const float k = fmod(-5.5, 2);\n"),
              ElementsAre(-1, -1.5, -1, -1.5, 1, 0, 0, 1, 0, 1, 11, 12));
}

TEST(ExecutedIntrinsics, SignGivesWholeNumbers) {
  const std::string statements = R"(
    uint u = 0x80000000u + uint(In[1]);
    Out[0] = sign(In[0]) / 2; Out[1] = sign(int(In[0])); Out[2] = sign(u); Out[3] = (sign(float2(In[0], In[1])) & 3).x;
    Out[4] = sign(In[0]) * 0.5; Out[5] = sign(float2x2(In[0], In[1], 0, 1))[0][0];)";
  EXPECT_THAT(outputs(statements, {-7, 2}, 6), ElementsAre(0, -1, 1, 3, -0.5, -1));
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
      "struct S { float2 a; int b[2]; }; static float f; static S s[2]; static int2x2 m;\n"
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

struct MatrixFunction {
  const char* expression;  // an expression of the matrices m and n and the scalar s
  float (*answer)(float m, float n, float s);
  float tolerance = 4e-6F;  // share of the answer, or of 1 where it is smaller
};

// Vulkan allows 4096 ULP for the inverse functions and 2^-11 for the others of this kind.
constexpr float kOfAngles = 5e-4F;

// Every intrinsic function that takes matrices, and every operator, works element by element.
TEST(ExecutedMatrices, FunctionsAndOperatorsTakeTheirElements) {
  const std::vector<MatrixFunction> all{
      {"abs(m)", [](float m, float, float) { return std::fabs(m); }},
      {"acos(m / 8)", [](float m, float, float) { return std::acos(m / 8); }, kOfAngles},
      {"asin(m / 8)", [](float m, float, float) { return std::asin(m / 8); }, kOfAngles},
      {"atan(m)", [](float m, float, float) { return std::atan(m); }, kOfAngles},
      {"atan2(m, n)", [](float m, float n, float) { return std::atan2(m, n); }, kOfAngles},
      {"ceil(m)", [](float m, float, float) { return std::ceil(m); }},
      {"clamp(m, -n, n)", [](float m, float n, float) { return std::fmin(std::fmax(m, -n), n); }},
      {"clamp(m, -1, s)", [](float m, float, float s) { return std::fmin(std::fmax(m, -1.0F), s); }},
      {"cos(m)", [](float m, float, float) { return std::cos(m); }, kOfAngles},
      {"cosh(m)", [](float m, float, float) { return std::cosh(m); }, kOfAngles},
      {"degrees(m)", [](float m, float, float) { return m * 57.2957795F; }},
      {"exp(m)", [](float m, float, float) { return std::exp(m); }},
      {"exp2(m)", [](float m, float, float) { return std::exp2(m); }},
      {"floor(m)", [](float m, float, float) { return std::floor(m); }},
      {"fmod(m, n)", [](float m, float n, float) { return std::fmod(m, n); }},
      {"frac(m)", [](float m, float, float) { return m - std::floor(m); }},
      {"ldexp(m, 2)", [](float m, float, float) { return m * 4; }},
      {"lerp(m, n, s)", [](float m, float n, float s) { return m + s * (n - m); }},
      {"lerp(m, n, n / 8)", [](float m, float n, float) { return m + n / 8 * (n - m); }},
      {"log(n)", [](float, float n, float) { return std::log(n); }},
      {"log10(n)", [](float, float n, float) { return std::log10(n); }},
      {"log2(n)", [](float, float n, float) { return std::log2(n); }},
      {"mad(m, n, m)", [](float m, float n, float) { return m * n + m; }},
      {"max(m, n)", [](float m, float n, float) { return std::fmax(m, n); }},
      {"max(m, 0)", [](float m, float, float) { return std::fmax(m, 0.0F); }},
      {"min(s, m)", [](float m, float, float s) { return std::fmin(s, m); }},
      {"pow(n, m)", [](float m, float n, float) { return std::pow(n, m); }},
      {"radians(m)", [](float m, float, float) { return m * 0.0174532925F; }},
      {"rcp(n)", [](float, float n, float) { return 1 / n; }},
      {"round(m)", [](float m, float, float) { return std::nearbyint(m); }},
      {"rsqrt(n)", [](float, float n, float) { return 1 / std::sqrt(n); }},
      {"saturate(m)", [](float m, float, float) { return std::fmin(std::fmax(m, 0.0F), 1.0F); }},
      {"sign(m)", [](float m, float, float) { return m > 0   ? 1.0F
                                                     : m < 0 ? -1.0F
                                                             : 0.0F; }},
      {"sin(m)", [](float m, float, float) { return std::sin(m); }, kOfAngles},
      {"sinh(m)", [](float m, float, float) { return std::sinh(m); }, kOfAngles},
      {"smoothstep(-8, 8, m)",
       [](float m, float, float) {
         const float t = (m + 8) / 16;
         return t * t * (3 - 2 * t);
       }},
      {"sqrt(n)", [](float, float n, float) { return std::sqrt(n); }},
      {"step(m, n)", [](float m, float n, float) { return n >= m ? 1.0F : 0.0F; }},
      {"tan(m)", [](float m, float, float) { return std::tan(m); }, kOfAngles},
      {"tanh(m)", [](float m, float, float) { return std::tanh(m); }, kOfAngles},
      {"trunc(m)", [](float m, float, float) { return std::trunc(m); }},
      {"-m", [](float m, float, float) { return -m; }},
      {"m + n", [](float m, float n, float) { return m + n; }},
      {"s - m", [](float m, float, float s) { return s - m; }},
      {"m * n", [](float m, float n, float) { return m * n; }},
      {"abs(m) * max(n, s)", [](float m, float n, float s) { return std::fabs(m) * std::fmax(n, s); }},
      {"m / n", [](float m, float n, float) { return m / n; }},
      {"m / s", [](float m, float, float s) { return m / s; }},
      {"s / n", [](float, float n, float s) { return s / n; }},
      {"m % n", [](float m, float n, float) { return std::fmod(m, n); }},
      {"s > 0 ? m : n", [](float m, float, float) { return m; }},
      {"(float2x3)(int2x3)m", [](float m, float, float) { return std::trunc(m); }},
      {"(int2x3)m / 2", [](float m, float, float) { return std::trunc(std::trunc(m) / 2); }},
      {"asfloat(asuint(m))", [](float m, float, float) { return m; }},
  };
  const std::vector<float> in{-2.75F, 3.5F, 0.5F, -0.25F, 2.5F, -1.5F, 0.75F};
  for (const MatrixFunction& function : all) {
    std::vector<testing::Matcher<float>> expected;
    for (int i = 0; i < 6; ++i) {
      const float answer = function.answer(in[i], static_cast<float>(i + 1), in[6]);
      expected.push_back(testing::FloatNear(answer, function.tolerance * std::fmax(1.0F, std::fabs(answer))));
    }
    const std::string statements = std::string(R"(
    float2x3 m = float2x3(In[0], In[1], In[2], In[3], In[4], In[5]); float s = In[6];
    float2x3 n = float2x3(1, 2, 3, 4, 5, 6 + 0 * s);
    float2x3 result = )") + function.expression +
                                   ";\n for (int i = 0; i < 6; ++i) Out[i] = result[i / 3][i % 3];";
    EXPECT_THAT(outputs(statements, in, 6), ElementsAreArray(expected)) << function.expression;
  }
}

TEST(ExecutedMatrices, ConditionsLookAtEveryElement) {
  const std::string statements = R"(
    float2x2 m = float2x2(In[0], In[1], In[2], In[3]);
    Out[0] = any(m); Out[1] = all(m); Out[2] = any(m * 0); Out[3] = all(abs(m) + 1);)";
  EXPECT_THAT(outputs(statements, {0, 0, 0, 2}, 4), ElementsAre(1, 0, 0, 1));
  EXPECT_THAT(outputs(statements, {1, -1, 3, 2}, 4), ElementsAre(1, 1, 0, 1));
}

TEST(ExecutedMatrices, AssignmentsWithAnOperator) {
  const std::string statements = R"(
    float2x2 m = float2x2(In[0], In[1], In[2], In[3]); float2x2 n = m + 1; S s; s.m[1] = m;
    m /= 4; s.m[1] /= n; n *= m; Out[0] = m[0][1]; Out[1] = s.m[1][1][0]; Out[2] = n[1][1];
    m %= 2; m -= 1; m++; Out[3] = m[1][1];
    int2x2 w = int2x2(9, 8, 7, 6); w /= 2; w <<= 1; w ^= 1; w += w; Out[4] = w[0][0]; Out[5] = w[int(In[0]) - 1][1];)";
  EXPECT_THAT(outputs(statements, {1, 2, 3, 10}, 6, "struct S { float2x2 m[2]; };\n"),
              ElementsAre(0.5F, 0.75F, 27.5F, 0.5F, 18, 18));
}

TEST(ExecutedMatrices, OfWholeNumbersAreIndexedAndPassed) {
  const std::string before = "int2x2 Twice(int2x2 m) { return m + m; } struct S { uint2x2 m[2]; };\n";
  const std::string statements = R"(
    int2x2 m = int2x2(In[0], In[1], In[2], In[3]); int i = int(In[1]) - 1;
    m[i][0] += 4; m = Twice(m); S s; s.m[0] = uint2x2(1, 2, 3, 4); s.m[1] = s.m[0] * 3u; s.m[i][i] = 7;
    Out[0] = m[i][i - 1]; Out[1] = (m * m - 2)[1][1]; Out[2] = s.m[i][i].y; Out[3] = s.m[i][0][1];
    Out[4] = max(m, -1)[0][0]; Out[5] = mad(m, m, 1)[0][0];)";
  EXPECT_THAT(outputs(statements, {-7, 2, 3, -1}, 6, before), ElementsAre(14, 2, 7, 6, -1, 197));
}

TEST(ExecutedMatrices, OperandsWithEffectsAreEvaluatedOnce) {
  const std::string before =
      "static float calls; float2x2 Next(float2x2 m) { calls += 1; return m + calls; }\n";
  const std::string statements = R"(
    float2x2 m = float2x2(In[0], In[1], In[2], In[3]);
    float2x2 r = max(Next(m), Next(m)) / Next(m); Out[0] = r[0][0]; Out[1] = calls; Out[2] = abs(Next(m))[1][1];)";
  EXPECT_THAT(outputs(statements, {1, 2, 3, 4}, 3, before), ElementsAre(0.75F, 3, 8));
}

// Get() returns two types, so that its calls have none before the compiler has chosen one.
TEST(ExecutedMatrices, ProductsOfUnknownTypesAreFoundInTheTree) {
  const std::string before =
      "float2x2 Get(float2x2 m) { return m; } float3x3 Get(float3x3 m) { return m; } float2 Get(float2 v) { "
      "return v; }\n";
  const std::string matrix = "float2x2 m = float2x2(In[0], In[1], In[2], In[3]);\n";
  EXPECT_THAT(outputs(matrix + "Out[0] = (Get(m) * Get(m))[0][1]; Out[1] = mul(Get(m), Get(m))[0][1]; "
                               "float2x2 n = m; n *= Get(m); Out[2] = n[1][0];",
                      {1, 2, 3, 4}, 3, before),
              ElementsAre(4, 10, 9));
  EXPECT_THAT(
      [&] {
        outputs(matrix + "Out[0] = (Get(float2(1, 2)) * Get(m)).x;", {1, 2, 3, 4}, 1, before);
      },
      ThrowsMessage<std::runtime_error>(HasSubstr("'*' of a vector and a matrix")));
}

TEST(ExecutedMatrices, WhatIsNotSupportedIsAnError) {
  const auto refusal = [](const std::string& statement) {
    return [statement] { outputs("float2x2 m = float2x2(In[0], In[1], 0, 1);\n" + statement, {1, 2}, 1); };
  };
  EXPECT_THAT(
      refusal("if (m == m) Out[0] = 1;"),
      ThrowsMessage<std::runtime_error>(HasSubstr(":4: error: not supported here: comparing matrices")));
  EXPECT_THAT(refusal("Out[0] = float2x2(1, 2, 3, 4) == float2x2(1, 2, 3, 5) ? 1 : 0;"),
              ThrowsMessage<std::runtime_error>(HasSubstr("comparing matrices")));
  EXPECT_THAT(refusal("bool2x2 b = m; Out[0] = b[0][0];"),
              ThrowsMessage<std::runtime_error>(HasSubstr("a matrix of bools")));
  EXPECT_THAT(refusal("float2x2 whole; Out[0] = modf(m, whole)[0][0];"),
              ThrowsMessage<std::runtime_error>(HasSubstr("modf() and frexp() of a matrix")));
  EXPECT_THAT(refusal("float2 v = float2(In[0], 1); v = v * m; Out[0] = v.x;"),
              ThrowsMessage<std::runtime_error>(HasSubstr("'*' does not combine a vector with a matrix")));
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
