// Small shaders of our own that use most of what ShaderLab has.
#pragma once

#include <string>
#include <vector>

#include "hlsl/source_text.h"

namespace penumbra::shaderlab {

inline std::string sample(const std::string& file) {
  return hlsl::read_source(std::string(PENUMBRA_SOURCE_DIR) + "/tests/shaderlab/samples/" + file).text;
}

// Properties of every type, two SubShaders, a Category, include blocks before and after programs.
inline const std::string kLitSample = sample("Lit.shader");
// The fixed-function pipeline and a surface shader.
inline const std::string kLegacySample = sample("Legacy.shader");

inline std::vector<std::string> all_samples() {
  return {kLitSample, kLegacySample, "Shader \"Samples/Empty\" {\n  SubShader { GrabPass { } }\n}\n"};
}

}  // namespace penumbra::shaderlab
