// Runs framebuffer reads on the device, against answers worked out here.
#include <gtest/gtest.h>

#include <stdexcept>

#include "preparation/drawn.h"
#include "shaders/compile.h"
#include "shaders/cross_compile.h"

namespace penumbra::preparation {
namespace {

// An input attachment read at a pixel is the texel of a texture there: SPIRV-Cross says it so in HLSL, which
// is drawn with textures for the attachments.
Drawing with_textures(const std::string& text, const std::string& output, Drawing drawing) {
  shaders::CompileRequest request;
  request.file = "fetch.hlsl";
  request.text = text;
  request.stage = hlsl::Stage::fragment;
  request.prepare = true;
  const shaders::CompileResult result = shaders::compile(request);
  if (result.spirv.empty()) throw std::runtime_error(format(result.diagnostics.front()));
  drawing.body = shaders::cross_compile(result.spirv, shaders::Target::hlsl50).text +
                 "float4 Main(float4 p : SV_Position) : SV_Target { SPIRV_Cross_Input i; i.gl_FragCoord = p; "
                 "return main(i)." +
                 output + "; }";
  return drawing;
}

Pixel sum(const Pixel& a, float scale, const Pixel& b) {
  return {a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2], a[3] + scale * b[3]};
}

TEST(ExecutedFramebufferFetch, BlocksReadTheirPixel) {
  const std::string text =
      "cbuffer hlslcc_SubpassInput_f_0 { float4 A; } cbuffer hlslcc_SubpassInput_h_1 { half4 B; }\n"
      "float4 Main(float4 p : SV_Position) : SV_Target { return A + B * 2; }\n";
  EXPECT_EQ(draw_unprepared(with_textures(text, "_entryPointOutput", {{}, {{"A", 10}, {"B", 50}}})),
            picture([](int x, int y) { return sum(texel(10, x, y), 2, texel(50, x, y)); }));
}

TEST(ExecutedFramebufferFetch, InoutTargetsBeginWithTheirPixel) {
  const std::string text =
      "void Main(float4 p : SV_Position, inout float4 c : SV_Target0) { c = c + c * 2; c.w = c.x; }\n";
  EXPECT_EQ(draw_unprepared(with_textures(text, "c", {{}, {{"penumbra_target0_float4", 20}}})),
            picture([](int x, int y) {
              Pixel pixel = sum(texel(20, x, y), 2, texel(20, x, y));
              pixel[3] = pixel[0];
              return pixel;
            }));
}

}  // namespace
}  // namespace penumbra::preparation
