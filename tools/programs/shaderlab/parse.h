// Reads a .shader file.
//
// What Unity's ShaderLab reference describes (https://docs.unity3d.com/Manual/SL-Reference.html, the legacy
// fixed-function commands included) becomes a tree. Keywords are read without regard to case.
//
// Guarantees: any bytes are read in linear time with bounded nesting. A place that cannot be read ends the
// parse with an error, and the tree then holds what stands before it. An unknown command and an unknown value
// are errors over which it goes on (warnings where the parse ends later). What is merely odd (a property
// declared twice, a tag's unknown value) is a warning. Diagnostics are in the order of the file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hlsl/diagnostic.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

struct ParsedShader {
  Shader shader;
  bool complete = true;  // false: `shader` ends at an error
  std::vector<hlsl::Diagnostic> diagnostics;
};

// `file`: as messages shall call it. Line endings and a byte order mark are normalised first.
ParsedShader parse_shader(std::string_view bytes, const std::string& file);

}  // namespace penumbra::shaderlab
