// Tests render state commands as they are drawn, for both directions of depth.
#include "resolve/raster_state.h"

#include <gmock/gmock.h>

#include "input/input_error_matcher.h"
#include "shaderlab/parse.h"

namespace penumbra::resolve {
namespace {

using gpu::Blend;
using gpu::DepthTest;
using testing::ElementsAre;
using testing::HasSubstr;

RasterState state_of(const std::string& commands, std::size_t targets = 2, bool reversed_z = true) {
  const shaderlab::ParsedShader parsed = shaderlab::parse_shader(
      "Shader \"A\" { SubShader { Pass {\n" + commands + "\nHLSLPROGRAM\nENDHLSL } } }", "a.shader");
  EXPECT_THAT(parsed.diagnostics, testing::IsEmpty()) << commands;
  const std::vector<shaderlab::Program> programs = shaderlab::programs(parsed.shader);
  return raster_state(shaderlab::render_commands(programs.at(0)), "a.shader", targets, reversed_z);
}

std::string refusal(const std::string& commands) {
  return input_error_of([&] { (void)state_of(commands); });
}

TEST(RasterState, WithoutCommandsItIsUnitys) {
  const RasterState state = state_of("");
  EXPECT_FALSE(state.both_faces);
  EXPECT_EQ(state.depth_test, DepthTest::greater_equal);
  EXPECT_EQ(state_of("", 2, false).depth_test, DepthTest::less_equal);
  EXPECT_TRUE(state.depth_write);
  EXPECT_FALSE(state.depth_clamp);
  EXPECT_THAT(state.blends, ElementsAre(Blend::none, Blend::none));
}

TEST(RasterState, DepthTestsAndOffsetsGoByTheDistanceFromTheViewer) {
  const std::vector<std::tuple<std::string, DepthTest, DepthTest>> tests{
      {"Less", DepthTest::greater, DepthTest::less},
      {"lequal", DepthTest::greater_equal, DepthTest::less_equal},
      {"Greater", DepthTest::less, DepthTest::greater},
      {"GEqual", DepthTest::less_equal, DepthTest::greater_equal},
      {"Equal", DepthTest::equal, DepthTest::equal},
      {"Always", DepthTest::always, DepthTest::always},
      {"Off", DepthTest::always, DepthTest::always}};
  for (const auto& [word, reversed, conventional] : tests) {
    EXPECT_EQ(state_of("ZTest " + word).depth_test, reversed) << word;
    EXPECT_EQ(state_of("ZTest " + word, 1, false).depth_test, conventional) << word;
  }
  const RasterState pushed = state_of("Offset 2, 3 ZWrite Off ZClip False");
  EXPECT_EQ(pushed.slope_depth_bias, -2.0F);
  EXPECT_EQ(pushed.constant_depth_bias, -3.0F);
  EXPECT_EQ(state_of("Offset 2, -3", 1, false).constant_depth_bias, -3.0F);
  EXPECT_FALSE(pushed.depth_write);
  EXPECT_TRUE(pushed.depth_clamp);
}

TEST(RasterState, BlendsAreThoseOfTheirTargets) {
  EXPECT_THAT(state_of("Blend One One").blends, ElementsAre(Blend::add, Blend::add));
  EXPECT_THAT(state_of("Blend One One Blend 1 SrcAlpha OneMinusSrcAlpha").blends,
              ElementsAre(Blend::add, Blend::alpha));
  EXPECT_THAT(state_of("Blend One One, One One Blend 0 Off").blends, ElementsAre(Blend::none, Blend::add));
  EXPECT_THAT(state_of("Blend One Zero BlendOp Max").blends, ElementsAre(Blend::none, Blend::none));
  EXPECT_THAT(state_of("Blend One One BlendOp 0 Min BlendOp 1 Max").blends,
              ElementsAre(Blend::smallest, Blend::largest));
  EXPECT_THAT(state_of("Blend One One BlendOp Max BlendOp Add").blends, ElementsAre(Blend::add, Blend::add));
}

RasterState with_stencil(const std::string& commands) {
  const shaderlab::ParsedShader parsed = shaderlab::parse_shader(
      "Shader \"A\" { SubShader { Pass {\n" + commands + "\nHLSLPROGRAM\nENDHLSL } } }", "a.shader");
  EXPECT_THAT(parsed.diagnostics, testing::IsEmpty()) << commands;
  const std::vector<shaderlab::Program> programs = shaderlab::programs(parsed.shader);
  return raster_state(shaderlab::render_commands(programs.at(0)), "a.shader", 1, true, StencilTarget::has);
}

TEST(RasterState, StencilIsThatOfBothFacesOrOfOne) {
  using gpu::StencilFace;
  using gpu::StencilOperation;
  using gpu::StencilTest;
  EXPECT_EQ(with_stencil("Cull Off").stencil, std::nullopt);
  EXPECT_EQ(with_stencil("Stencil { Ref 0 }").stencil, gpu::StencilState{});
  const gpu::StencilState state = *with_stencil(
                                       "Stencil { Ref 3 ReadMask 15 WriteMask 240 Comp notequal Pass Zero "
                                       "ZFailFront DecrWrap ZFailBack incrwrap FailBack Invert CompBack 4 }")
                                       .stencil;
  EXPECT_EQ(state.reference, 3);
  EXPECT_EQ(state.read_mask, 15);
  EXPECT_EQ(state.write_mask, 240);
  EXPECT_EQ(state.front, (StencilFace{StencilTest::not_equal, StencilOperation::keep,
                                      StencilOperation::decrement_wrap, StencilOperation::zero}));
  EXPECT_EQ(state.back, (StencilFace{StencilTest::less_equal, StencilOperation::invert,
                                     StencilOperation::increment_wrap, StencilOperation::zero}));
  const std::vector<std::pair<std::string, StencilOperation>> operations{
      {"Keep", StencilOperation::keep},
      {"Zero", StencilOperation::zero},
      {"Replace", StencilOperation::replace},
      {"IncrSat", StencilOperation::increment},
      {"DecrSat", StencilOperation::decrement},
      {"Invert", StencilOperation::invert},
      {"IncrWrap", StencilOperation::increment_wrap},
      {"DecrWrap", StencilOperation::decrement_wrap}};
  for (std::size_t number = 0; number < operations.size(); ++number) {
    const auto& [word, operation] = operations[number];
    EXPECT_EQ(with_stencil("Stencil { Pass " + word + " }").stencil->front.pass, operation) << word;
    EXPECT_EQ(with_stencil("Stencil { PassBack " + std::to_string(number) + " }").stencil->back.pass,
              operation)
        << word;
  }
  const std::vector<std::string> tests{"Never",   "Less",     "Equal",  "LEqual",
                                       "Greater", "NotEqual", "GEqual", "Always"};
  for (std::size_t number = 0; number < tests.size(); ++number)
    EXPECT_EQ(with_stencil("Stencil { Comp " + tests[number] + " }").stencil->back.test,
              static_cast<StencilTest>(number))
        << tests[number];
  EXPECT_EQ(with_stencil("Stencil { Ref 1 } Stencil { Comp Less }").stencil->reference, 0)
      << "the later one replaces the earlier";
}

TEST(RasterState, WhatIsNotDrawnIsRefusedAtItsLine) {
  EXPECT_EQ(refusal("Cull Off ColorMask RGBA Conservative False"), "no error");
  EXPECT_THAT(refusal("\nBlend DstColor Zero"),
              HasSubstrs("a.shader:3: 'Blend DstColor Zero' is not drawn here", "One One"));
  EXPECT_THAT(refusal("Blend One One, One Zero"), HasSubstr("alpha alike"));
  EXPECT_THAT(refusal("BlendOp Sub"), HasSubstr("Add, Min and Max"));
  EXPECT_THAT(refusal("ZTest NotEqual"), HasSubstr("'ZTest NotEqual'"));
  EXPECT_THAT(refusal("ColorMask RGB"), HasSubstr("all channels are written"));
  EXPECT_THAT(refusal("Stencil { Ref 1 }"),
              HasSubstrs("'Stencil' is not drawn here", "the pass has no stencil"));
  EXPECT_THAT(refusal("AlphaToMask On"), HasSubstr("'AlphaToMask On'"));
}

}  // namespace
}  // namespace penumbra::resolve
