// Reads a .shader file.
//
// What Unity's ShaderLab reference describes (https://docs.unity3d.com/Manual/SL-Reference.html, the legacy
// fixed-function commands included) becomes a tree. Keywords are read without regard to case. Commands are
// read in their general shape; what their values mean is not checked.
//
// Guarantees: any bytes are read in linear time with bounded nesting. There is at most one error, at the
// first place that cannot be read, and the tree then holds what stands before it. What is merely odd (an
// unknown command, a property declared twice) is a warning. Diagnostics are in the order of the file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hlsl/diagnostic.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

struct ParsedShader {
  Shader shader;
  std::vector<hlsl::Diagnostic> diagnostics;
};

// `file`: as messages shall call it. Line endings and a byte order mark are normalised first.
ParsedShader parse_shader(std::string_view bytes, const std::string& file);

}  // namespace penumbra::shaderlab
