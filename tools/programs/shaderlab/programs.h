// The programs of a .shader file, each as a text of its own that keeps the file's lines and columns.
//
// A program's text is the file with a blank for every byte outside the program's block and the include blocks
// that apply to it; newlines stay. So line and column of the text are those of the file, for diagnostics and
// for the preprocessor's __LINE__. #line directives are added only where a block must move: an include block
// after the program, or one that ends on the line on which the next begins.
//
// The include blocks that apply follow Unity's rule: "Unity includes this code in all shader programs that
// are defined in HLSLPROGRAM blocks, anywhere in this source file"
// (https://docs.unity3d.com/Manual/shader-shaderlab-code-blocks.html), likewise CGINCLUDE in CGPROGRAM and
// GLSLINCLUDE in GLSLPROGRAM. So those of one language apply, in source order, before the program, whatever
// SubShader or Pass they are in.
#pragma once

#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

struct Program {
  std::string file;
  std::string text;
  Language language = Language::hlsl;
  Place place;  // place of HLSLPROGRAM
  // Unity puts HLSLSupport.cginc and UnityShaderVariables.cginc before CGPROGRAM code
  // (https://docs.unity3d.com/Manual/SL-BuiltinIncludes.html). They are not in `text`.
  bool implicit_includes = false;
  bool is_surface_shader = false;  // #pragma surface: Unity generates the passes
  bool is_ray_tracing = false;     // #pragma raytracing: no stage of the raster pipeline
  int sub_shader_index = 0;        // index in the order of the file
  int pass_index = -1;  // index in its SubShader, including UsePass and GrabPass; -1 outside any Pass
  // These point into the tree given to programs().
  const Shader* shader = nullptr;
  const SubShader* sub_shader = nullptr;
  const Pass* pass = nullptr;  // nullptr outside any Pass
};

// The programs are in the order of SubShaders and Passes. The pointers are valid as long as `shader` stays at
// its address.
std::vector<Program> programs(const Shader& shader);

// Returns the name of the program's Pass as written, or "".
std::string_view pass_name(const Program& program);

// Returns the value of a tag that applies to the program: that of its Pass, else of its SubShader, else of
// the Categories around it from the inside out; nullptr if none has it.
const std::string* effective_tag(const Program& program, std::string_view key);

// The render state commands that apply to a program: Cull, ZTest, Blend and so on.
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
