// Tests which render state holds for a pass: its own, its SubShader's, its Categories'.
#include "shaderlab/programs.h"

#include <gmock/gmock.h>

#include "shaderlab/parse.h"

namespace penumbra::shaderlab {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(RenderCommands, GoFromTheOutsideInAndPropertiesHaveTheirDefaults) {
  const ParsedShader parsed = parse_shader(
      R"(Shader "A" {
Properties { _Cull("Cull", Float) = 2 _Slope("Slope", Range(0, 4)) = 1.5 }
Category { Cull Off
SubShader { ZWrite Off
Pass { Cull [_Cull] Offset [_Slope], -1 Blend 1 One One, Zero One ZTest [_Missing]
Stencil { Ref 2 }
HLSLPROGRAM
ENDHLSL }
Pass { HLSLPROGRAM
ENDHLSL } } } })",
      "a.shader");
  ASSERT_THAT(parsed.diagnostics, IsEmpty());
  const std::vector<Program> found = programs(parsed.shader);
  ASSERT_EQ(found.size(), 2U);
  std::vector<std::string> lines;
  for (const RenderCommand& command : render_commands(found[0])) {
    std::string line = std::to_string(command.place.line) + ": " + command.name;
    for (const std::string& value : command.values) line += " " + value;
    lines.push_back(line + (command.block.empty() ? "" : " {}"));
  }
  EXPECT_THAT(lines, ElementsAre("3: Cull Off", "4: ZWrite Off", "5: Cull 2", "5: Offset 1.5 -1",
                                 "5: Blend 1 One One Zero One", "5: ZTest 0", "6: Stencil {}"));
  EXPECT_EQ(render_commands(found[1]).size(), 2U);
}

}  // namespace
}  // namespace penumbra::shaderlab
