// Tests the rules negative-pow and nan-check.
#include "lint/arithmetic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lint/linted_shader.h"

namespace penumbra::lint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<std::string> pow_of(const std::string& expression, const std::string& statements = {}) {
  return findings_of("negative-pow", fragment(statements, expression, "float _Power; float3 _Direction;\n"));
}

TEST(NegativePow, ABaseOfUnknownSign) {
  EXPECT_THAT(
      pow_of("pow(uv.x, 2.2)"),
      ElementsAre("4:12 warning negative-pow: pow of a base that may be negative gives NaN: bound it with "
                  "abs, max or saturate"));
  EXPECT_THAT(pow_of("pow(uv.x - 0.5, _Power)"), SizeIs(1));
  EXPECT_THAT(pow_of("pow(dot(uv, uv.yx), _Power)"), SizeIs(1));
  EXPECT_THAT(pow_of("pow(max(uv.x, -1), _Power)"), SizeIs(1));
}

TEST(NegativePow, ABaseThatCannotBeNegative) {
  for (const char* base :
       {"abs(uv.x)", "saturate(uv.x)", "max(uv.x, 0)", "1 - saturate(uv.x)", "uv.x * uv.x", "dot(uv, uv)",
        "sqrt(uv.x)", "exp(uv.x)", "frac(uv.x)", "length(uv)", "0.5 + 0.5 * sin(uv.x)",
        "smoothstep(0, 1, uv.x)", "lerp(0.1, saturate(uv.x), saturate(uv.y))", "saturate(uv.x) / 3",
        "(uv.x > 0.5 ? 1.0 : 0.25)", "pow(abs(uv.y), 1.5)"})
    EXPECT_THAT(pow_of("pow(" + std::string(base) + ", _Power)"), IsEmpty()) << base;
}

TEST(NegativePow, LoopCountersThatGrowFromZero) {
  const std::string loop =
      "    float sum = 0;\n    [loop] for (int i = 0; i < flat; ++i) sum += pow(i + 0.5, _Power);\n";
  EXPECT_THAT(pow_of("sum", loop), IsEmpty());
  const std::string down =
      "    float sum = 0;\n    [loop] for (int i = 8; i > flat; --i) sum += pow(i + 0.5, _Power);\n";
  EXPECT_THAT(pow_of("sum", down), SizeIs(1));
}

TEST(NegativePow, WholeExponentsAreProducts) {
  EXPECT_THAT(pow_of("pow(uv.x, 2)"), IsEmpty());
  EXPECT_THAT(pow_of("pow(uv, 5.0).xyxy"), IsEmpty());
}

TEST(NegativePow, ComponentsAreFollowed) {
  EXPECT_THAT(
      pow_of("pow(v.z, _Power)", "    float4 v = float4(uv, 0.5, -1);\n    v.z = clamp(v.z * uv.x, 0, 8);\n"),
      IsEmpty());
  EXPECT_THAT(
      pow_of("pow(v.w, _Power)", "    float4 v = float4(uv, 0.5, -1 * uv.x);\n    v.z = clamp(v.z, 0, 8);\n"),
      SizeIs(1));
}

std::vector<std::string> nan(const std::string& expression) {
  return findings_of("nan-check", fragment("    float x = uv.x / uv.y;\n", expression));
}

TEST(NanCheck, TestsThatFastMathematicsRemoves) {
  EXPECT_THAT(nan("isnan(x) ? 0 : x"),
              ElementsAre("4:12 warning nan-check: compilers may remove this test for NaN under fast math: "
                          "test the bits, (asuint(x) & 0x7FFFFFFF) > 0x7F800000"));
  EXPECT_THAT(nan("x != x ? 0 : x"), SizeIs(1));
  EXPECT_THAT(nan("isfinite(x) ? x : 0"),
              ElementsAre(testing::HasSubstr("(asuint(x) & 0x7F800000) != 0x7F800000 for finite numbers")));
}

TEST(NanCheck, TestsThatStay) {
  EXPECT_THAT(nan("(asuint(x) & 0x7FFFFFFF) > 0x7F800000 ? 0 : x"), IsEmpty());
  EXPECT_THAT(nan("x != uv.x ? 0 : x"), IsEmpty());
}

}  // namespace
}  // namespace penumbra::lint
