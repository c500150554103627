// Tests reads of the pixel that is about to be written: what stands there instead, and what Vulkan, Metal and
// the others make of it.
#include "preparation/after_pass.h"
#include "preparation/passes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "hlsl/source_text.h"
#include "shaders/compile.h"
#include "shaders/cross_compile.h"
#include "shaders/pipeline_interface.h"

namespace penumbra::preparation {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string unchanged(const std::string& text) {
  const TokenText tokens(text, "m");
  return tokens.spelled(0, tokens.size());
}

TEST(FramebufferFetch, BlocksOfThatNameAreInputAttachments) {
  EXPECT_EQ(
      after<read_framebuffer>(
          "cbuffer hlslcc_SubpassInput_h_1 { half4 a; } float4 F() { return a.x + s.a; }"),
      "[[vk::input_attachment_index(1)]] SubpassInput<half4> a; float4 F() { return a .SubpassLoad() .x + "
      "s.a; }");
  EXPECT_EQ(after<read_framebuffer>(
                "cbuffer hlslcc_SubpassInput_U_7 { uint4 a[8]; } uint4 F(int i) { return a[i + 1]; }"),
            "[[vk::input_attachment_index(7)]] SubpassInputMS<uint4> a; uint4 F(int i) { return a "
            ".SubpassLoad( i + 1 ) ; }");
}

TEST(FramebufferFetch, InoutTargetsAreLoadedAtTheStart) {
  EXPECT_EQ(
      after<read_framebuffer>("void Frag(float4 p : SV_Position, inout half3 c : SV_Target) { c *= 2; }"),
      "[[vk::input_attachment_index(0)]] SubpassInput<half4> penumbra_target0_half4; void Frag(float4 p : "
      "SV_Position, out half3 c : SV_Target) { c = (half3)penumbra_target0_half4.SubpassLoad(); c *= 2; }");
}

TEST(FramebufferFetch, OtherBlocksAndParametersStay) {
  for (const char* text :
       {"cbuffer hlslcc_SubpassInput_x_1 { float4 a; } float4 F() { return a; }",
        "cbuffer hlslcc_SubpassInput_f_9 { float4 a; } float4 F() { return a; }",
        "cbuffer hlslcc_SubpassInput_f_1 { float4 a; float4 b; } float4 F() { return a; }",
        "cbuffer Other { float4 a; } float4 F() { return a; }", "void F(inout float4 c : COLOR0) { }",
        "void F(inout float4 c) { }", "void F(inout S c : SV_Target) { }",
        "void F(inout float4 c : SV_Target;", "void F(inout float4 c : SV_Target) { } void Main() { F(c); }",
        "void F(inout float4 c : SV_Target) { } void Main() { if (a) b; else F(c); }"})
    EXPECT_EQ(after<read_framebuffer>(text), unchanged(text));
}

shaders::CompileResult compiled(const std::string& text, hlsl::Stage stage = hlsl::Stage::fragment,
                                bool prepare = true) {
  shaders::CompileRequest request;
  request.file = "fetch.hlsl";
  request.text = text;
  request.stage = stage;
  request.prepare = prepare;
  return shaders::compile(request);
}

const std::string kDeferred =
    hlsl::read_source(PENUMBRA_SOURCE_DIR "/tests/preparation/taken/framebuffer_fetch.hlsl").text;

const std::string kInout =
    "void Main(float4 p : SV_Position, inout half4 c : SV_Target0, inout float2 d : SV_Target1)\n"
    "{ c.rgb = 1 - c.rgb; d += p.xy; }\n";

std::vector<std::string> attachments(const std::vector<std::uint32_t>& spirv) {
  std::vector<std::string> names;
  for (const shaders::Descriptor& descriptor : shaders::pipeline_interface(spirv, "Main").descriptors)
    if (descriptor.kind == shaders::DescriptorKind::input_attachment) names.push_back(descriptor.name);
  std::sort(names.begin(), names.end());
  return names;
}

TEST(FramebufferFetch, VulkanReadsInputAttachments) {
  const shaders::CompileResult deferred = compiled(kDeferred);
  EXPECT_THAT(deferred.diagnostics, IsEmpty()) << format(deferred.diagnostics.at(0));
  EXPECT_THAT(attachments(deferred.spirv),
              testing::ElementsAre("hlslcc_fbinput_0", "hlslcc_fbinput_2", "hlslcc_fbinput_3"));
  const shaders::CompileResult inout = compiled(kInout);
  EXPECT_THAT(inout.diagnostics, IsEmpty()) << format(inout.diagnostics.at(0));
  EXPECT_THAT(attachments(inout.spirv),
              testing::ElementsAre("penumbra_target0_half4", "penumbra_target1_float4"));
  const shaders::PipelineInterface interface = shaders::pipeline_interface(inout.spirv, "Main");
  EXPECT_THAT(interface.inputs, IsEmpty());
  EXPECT_EQ(interface.outputs.size(), 2U);
}

// Without the pass the pixel is taken for something that the vertex stage hands over.
TEST(FramebufferFetch, IsNeeded) {
  const shaders::CompileResult inout = compiled(kInout, hlsl::Stage::fragment, false);
  EXPECT_EQ(shaders::pipeline_interface(inout.spirv, "Main").inputs.size(), 2U);
}

TEST(FramebufferFetch, TheVertexStageOfSuchATextHasNone) {
  const shaders::CompileResult vertex = compiled("#define VERTEX\n" + kDeferred, hlsl::Stage::vertex);
  EXPECT_THAT(vertex.diagnostics, IsEmpty()) << format(vertex.diagnostics.at(0));
  EXPECT_THAT(attachments(vertex.spirv), IsEmpty());
}

TEST(FramebufferFetch, MetalReadsThePixelAndOthersATexture) {
  const std::vector<std::uint32_t> spirv = compiled(kInout).spirv;
  const auto emitted = [&](shaders::Target target) { return shaders::cross_compile(spirv, target); };
  EXPECT_THAT(emitted(shaders::Target::msl23).text,
              testing::AllOf(HasSubstr("penumbra_target0_half4 [[color(0)]]"),
                             HasSubstr("penumbra_target1_float4 [[color(1)]]")));
  for (const shaders::Target target : {shaders::Target::msl20, shaders::Target::msl22}) {
    ASSERT_EQ(emitted(target).diagnostics.size(), 1U);
    EXPECT_THAT(emitted(target).diagnostics[0].message, HasSubstr("MSL 2.3"));
  }
  EXPECT_THAT(emitted(shaders::Target::essl310).text,
              HasSubstr("texelFetch(penumbra_target0_half4, ivec2(gl_FragCoord"));
  EXPECT_THAT(emitted(shaders::Target::hlsl50).text, HasSubstr("penumbra_target0_half4.Load("));
}

}  // namespace
}  // namespace penumbra::preparation
