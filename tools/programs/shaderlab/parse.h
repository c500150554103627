// Reads a .shader file.
//
// The tree has everything that Unity's ShaderLab reference describes
// (https://docs.unity3d.com/Manual/SL-Reference.html, the legacy fixed-function commands included). Keywords
// are read without regard to case.
//
// Guarantees: any bytes are read in linear time with bounded nesting. A syntax error ends the parse, and the
// tree then contains what precedes it. After an unknown command or an unknown value, which are errors,
// parsing continues (they are warnings if the parse ends later). Questionable code (a property declared
// twice, a tag's unknown value) is a warning. Diagnostics are in source order.
#pragma once

#include "hlsl/diagnostic.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

struct ParsedShader {
  Shader shader;
  bool complete = true;  // if false, `shader` ends at an error
  std::vector<hlsl::Diagnostic> diagnostics;
};

// `file` is its name in diagnostics. Line endings and a byte order mark are normalised first.
ParsedShader parse_shader(std::string_view bytes, const std::string& file);

}  // namespace penumbra::shaderlab
