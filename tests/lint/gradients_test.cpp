// Tests the rules divergent-derivative, gradient-in-varying-loop and unroll-without-bound.
#include "lint/gradients.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lint/linted_shader.h"

namespace penumbra::lint {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* resources = "Texture2D _Map; SamplerState sampler_Map; float _Cut; int _Count;\n";

std::string shader(const std::string& statements, const std::string& before = {}) {
  return fragment("    float4 c = 0;\n" + statements, "c", resources + before);
}
std::vector<std::string> divergent(const std::string& text) {
  return findings_of("divergent-derivative", text);
}
std::vector<std::string> in_loop(const std::string& text) {
  return findings_of("gradient-in-varying-loop", text);
}

constexpr const char* sample = "c += _Map.Sample(sampler_Map, uv);\n";

TEST(DivergentDerivative, UnderAConditionThatVaries) {
  EXPECT_THAT(divergent(shader(std::string("    if (uv.x > 0.5)\n        ") + sample)),
              ElementsAre("6:19 warning divergent-derivative: a texture is sampled with implicit derivatives "
                          "where only some pixels of a quad may be active, by the condition at line 5: "
                          "sample before the condition, or use SampleLevel or SampleGrad"));
}

TEST(DivergentDerivative, UnderAUniformOrFlatCondition) {
  EXPECT_THAT(divergent(shader(std::string("    if (_Cut > 0.5) ") + sample)), IsEmpty());
  EXPECT_THAT(divergent(shader(std::string("    if (flat > 1) ") + sample)), IsEmpty());
}

TEST(DivergentDerivative, WithItsLevelOrGradientsGiven) {
  EXPECT_THAT(divergent(shader("    if (uv.x > 0.5) c += _Map.SampleLevel(sampler_Map, uv, 0);\n")),
              IsEmpty());
  EXPECT_THAT(divergent(shader("    if (uv.x > 0.5) c += _Map.SampleGrad(sampler_Map, uv, 0.1, 0.1);\n")),
              IsEmpty());
}

TEST(DivergentDerivative, BeforeTheConditionOrAfterIt) {
  EXPECT_THAT(divergent(shader(std::string("    ") + sample + "    if (uv.x > 0.5) c *= 2;\n    " + sample)),
              IsEmpty());
}

TEST(DivergentDerivative, AfterAnEarlyReturn) {
  EXPECT_THAT(divergent(shader(std::string("    if (uv.x > 0.5) return c;\n    ") + sample)),
              ElementsAre(HasSubstr("6:15 warning divergent-derivative")));
  EXPECT_THAT(divergent(shader(std::string("    if (_Cut > 0.5) return c;\n    ") + sample)), IsEmpty());
}

TEST(DivergentDerivative, AfterDiscardPixelsLiveOnForDerivatives) {
  EXPECT_THAT(divergent(shader(std::string("    if (uv.x > 0.5) discard;\n    ") + sample)), IsEmpty());
  EXPECT_THAT(divergent(shader(std::string("    clip(uv.x - _Cut);\n    ") + sample)), IsEmpty());
  EXPECT_THAT(divergent(shader(std::string("    Cut(uv.x);\n    ") + sample,
                               "void Cut(float a) { if (a > 0.5) discard; }\n")),
              IsEmpty());
}

TEST(DivergentDerivative, DerivativesThemselves) {
  EXPECT_THAT(
      divergent(shader("    if (uv.x > 0.5) c += ddx(uv.x);\n")),
      ElementsAre("5:26 warning divergent-derivative: a derivative is taken where only some pixels of a quad "
                  "may be active, by the condition at line 5: take it before the condition"));
  EXPECT_THAT(divergent(shader("    if (uv.x > 0.5) c += fwidth(uv.y);\n")), testing::SizeIs(1));
}

TEST(DivergentDerivative, InAFunctionCalledUnderACondition) {
  const std::string before = "float4 Read(float2 uv)\n{\n    return _Map.Sample(sampler_Map, uv);\n}\n";
  EXPECT_THAT(
      divergent(shader("    if (uv.x > 0.5) c += Read(uv);\n", before)),
      ElementsAre(HasSubstr("4:17 warning divergent-derivative: a texture is sampled with implicit "
                            "derivatives where only some pixels of a quad may be active, by the condition at "
                            "line 9")));
  EXPECT_THAT(divergent(shader("    c += Read(uv);\n", before)), IsEmpty());
}

TEST(DivergentDerivative, ThroughVariablesSetUnderACondition) {
  EXPECT_THAT(
      divergent(shader(std::string("    bool hit = false;\n    if (uv.x > 0.5) hit = true;\n    if (hit) ") +
                       sample)),
      testing::SizeIs(1));
  EXPECT_THAT(
      divergent(shader(std::string("    bool hit = false;\n    if (_Cut > 0.5) hit = true;\n    if (hit) ") +
                       sample)),
      IsEmpty());
}

TEST(DivergentDerivative, InALoopWithUniformRounds) {
  EXPECT_THAT(divergent(shader(std::string("    for (int i = 0; i < _Count; ++i) ") + sample)), IsEmpty());
  EXPECT_THAT(in_loop(shader(std::string("    for (int i = 0; i < _Count; ++i) ") + sample)), IsEmpty());
  EXPECT_THAT(in_loop(shader(std::string("    [loop] for (int i = 0; i < 4; ++i) ") + sample)), IsEmpty());
}

TEST(DivergentDerivative, AfterALoopWithVaryingRounds) {
  const std::string count = "    int i = 0;\n    for (; i < 8; ++i) if (i > uv.x * 8) break;\n";
  EXPECT_THAT(divergent(shader(count + "    " + sample)), IsEmpty());
  EXPECT_THAT(divergent(shader(count + "    if (i > 3) " + sample)), testing::SizeIs(1));
}

TEST(GradientInVaryingLoop, IterationsThatDifferWithoutABound) {
  EXPECT_THAT(
      in_loop(shader(std::string("    for (int i = 0; i < uv.x * 8; ++i)\n        ") + sample)),
      ElementsAre("6:19 error gradient-in-varying-loop: derivatives are taken in divergent control "
                  "flow: the loop's number of iterations differs between pixels, by the condition at "
                  "line 5; Direct3D must unroll it and finds no bound: use SampleLevel or SampleGrad"));
}

TEST(GradientInVaryingLoop, AVaryingBreakFromABoundedLoopIsAWarning) {
  const std::string loop =
      std::string("    for (int i = 0; i < 8; ++i)\n    {\n        if (i > uv.x * 8) break;\n        ") +
      sample + "    }\n";
  EXPECT_THAT(
      in_loop(shader(loop)),
      ElementsAre(
          "8:19 warning gradient-in-varying-loop: derivatives are taken in divergent control flow: "
          "the loop's number of iterations differs between pixels, by the condition at line 7; Direct3D "
          "unrolls it, elsewhere they are undefined: use SampleLevel or SampleGrad"));
  EXPECT_THAT(divergent(shader(loop)), IsEmpty()) << "one cause, one rule";
}

TEST(GradientInVaryingLoop, AConditionInTheLoopThatDoesNotLeaveItIsTheOtherRule) {
  const std::string loop =
      std::string("    for (int i = 0; i < 8; ++i)\n        if (i > uv.x * 8) ") + sample;
  EXPECT_THAT(in_loop(shader(loop)), IsEmpty());
  EXPECT_THAT(divergent(shader(loop)), testing::SizeIs(1));
}

std::vector<std::string> unroll(const std::string& text) {
  return findings_of("unroll-without-bound", text);
}

TEST(UnrollWithoutBound, ABoundThatOnlyTheHostKnows) {
  EXPECT_THAT(unroll(shader("    [unroll]\n    for (int i = 0; i < _Count; ++i) c += i;\n")),
              ElementsAre("6:5 error unroll-without-bound: [unroll] on a loop without a constant bound on "
                          "its iterations: use [loop], or break after a constant number of iterations"));
}

TEST(UnrollWithoutBound, AConstantBound) {
  EXPECT_THAT(unroll(shader("    [unroll] for (int i = 0; i < 4; ++i) c += i;\n")), IsEmpty());
  EXPECT_THAT(
      unroll(shader("    [unroll] for (int i = 0; i < _Count; ++i) { if (i == 8) break; c += i; }\n")),
      IsEmpty());
  EXPECT_THAT(unroll(shader("    [unroll(8)] for (int i = 0; i < _Count; ++i) c += i;\n")), IsEmpty());
  EXPECT_THAT(unroll(shader("    [unroll (8)]\n    for (int i = 0; i < _Count; ++i) c += i;\n")), IsEmpty());
  EXPECT_THAT(unroll(shader("    [loop] for (int i = 0; i < _Count; ++i) c += i;\n")), IsEmpty());
}

TEST(UnrollWithoutBound, ABoundThatIsConstantWhereTheFunctionIsCalled) {
  const std::string before =
      "float Sum(int n)\n{\n    float s = 0;\n    [unroll] for (int i = 0; i < n; ++i) s += i;\n"
      "    return s;\n}\n";
  EXPECT_THAT(unroll(shader("    c += Sum(4);\n", before)), IsEmpty());
  EXPECT_THAT(unroll(shader("    c += Sum(_Count);\n", before)), testing::SizeIs(1));
}

}  // namespace
}  // namespace penumbra::lint
