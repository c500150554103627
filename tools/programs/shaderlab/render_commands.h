// The render state commands that apply to a program: Cull, ZTest, Blend and so on.
#pragma once

#include <string>
#include <vector>

#include "shaderlab/programs.h"

namespace penumbra::shaderlab {

struct RenderCommand {
  std::string name;  // the name as written
  // The values as written, without commas; for [_Name] the default of that property.
  std::vector<std::string> values;
  Place place;
  std::vector<RenderCommand> block{};  // the commands in the braces of Stencil { ... }
};

// Returns the commands of the Categories around the program from the outside in, of its SubShader and of its
// Pass: a later one replaces an earlier one of the same name, and of the same target where it names one. A
// property that the shader does not declare is 0.
std::vector<RenderCommand> render_commands(const Program& program);

}  // namespace penumbra::shaderlab
