// Tests a vertex shader that chooses the layer it draws to: what each target makes of it.
#include <gmock/gmock.h>

#include "shaders/compile.h"
#include "shaders/cross_compile.h"
#include "shaders/gl_check.h"

namespace penumbra::shaders {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// The text has an input, too: SPIRV-Cross calls both sides TEXCOORD in HLSL.
constexpr const char* vertex_text = R"(
struct Eye
{
    float4 position : SV_Position;
    float2 uv : TEXCOORD0;
    uint layer : SV_RenderTargetArrayIndex;
};
Eye Main(float2 corner : TEXCOORD0, float2 uv : TEXCOORD1, uint instance : SV_InstanceID)
{
    Eye eye;
    eye.position = float4(corner, 0.5, 1.0);
    eye.uv = uv;
    eye.layer = instance & 1;
    return eye;
}
)";

CrossCompileResult emitted(const std::string& text, hlsl::Stage stage, Target target) {
  CompileRequest request;
  request.file = "shader.hlsl";
  request.text = text;
  request.stage = stage;
  return cross_compile(compile(request).spirv, target);
}

std::string vertex_for(Target target) {
  const CrossCompileResult result = emitted(vertex_text, hlsl::Stage::vertex, target);
  EXPECT_TRUE(result.diagnostics.empty()) << target_name(target);
  return result.text;
}

TEST(VertexLayer, OpenGlAsksForTheExtensionAndTheDriverTakesIt) {
  for (const Target target : {Target::glsl410, Target::glsl450}) {
    const std::string text = vertex_for(target);
    EXPECT_THAT(text, HasSubstr("#extension GL_ARB_shader_viewport_layer_array : require"));
    EXPECT_THAT(text, HasSubstr("gl_Layer = "));
    EXPECT_THAT(gl_check({{hlsl::Stage::vertex, text}}, target), ElementsAre()) << target_name(target);
  }
}

TEST(VertexLayer, OpenGlEsHasNone) {
  const CrossCompileResult result = emitted(vertex_text, hlsl::Stage::vertex, Target::essl310);
  EXPECT_TRUE(result.text.empty());
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics.front().file, "essl310");
  EXPECT_THAT(result.diagnostics.front().message, HasSubstr("SV_RenderTargetArrayIndex"));
}

TEST(VertexLayer, Direct3DHasItUnderItsOwnSemantic) {
  for (const Target target : {Target::hlsl50, Target::hlsl51}) {
    const std::string text = vertex_for(target);
    const std::string outputs = text.substr(text.find("struct SPIRV_Cross_Output"));
    EXPECT_THAT(outputs, HasSubstr(" : SV_RenderTargetArrayIndex;"));
    EXPECT_THAT(outputs, HasSubstr(" : TEXCOORD0;")) << "the shader's own";
    EXPECT_THAT(outputs, Not(HasSubstr("TEXCOORD1")));
    EXPECT_THAT(text, HasSubstr(" : TEXCOORD1;")) << "an input is no output";
  }
}

TEST(VertexLayer, MetalAndShadersWithoutOneAreLeftAlone) {
  EXPECT_THAT(vertex_for(Target::msl23), HasSubstr("[[render_target_array_index]]"));
  const std::string plain = "float4 Main(float3 p : POSITION) : SV_Position { return float4(p, 1); }";
  for (const Target target : all_targets) {
    const CrossCompileResult result = emitted(plain, hlsl::Stage::vertex, target);
    EXPECT_TRUE(result.diagnostics.empty()) << target_name(target);
    EXPECT_THAT(result.text, Not(HasSubstr("ayer")));
    EXPECT_THAT(result.text, Not(HasSubstr("SV_RenderTargetArrayIndex")));
  }
}

// The fragment stage reads it, and has it everywhere but in OpenGL ES 3.1.
TEST(VertexLayer, AFragmentStageReadsIt) {
  const std::string fragment =
      "float4 Main(float4 p : SV_Position, uint layer : SV_RenderTargetArrayIndex) : SV_Target { return "
      "layer; }";
  EXPECT_THAT(emitted(fragment, hlsl::Stage::fragment, Target::hlsl50).text,
              HasSubstr(" : SV_RenderTargetArrayIndex;"));
  const std::string gl = emitted(fragment, hlsl::Stage::fragment, Target::glsl450).text;
  EXPECT_THAT(gl_check({{hlsl::Stage::fragment, gl}}, Target::glsl450), ElementsAre());
}

}  // namespace
}  // namespace penumbra::shaders
