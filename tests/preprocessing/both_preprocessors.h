// Reads a source by this project's preprocessor and by glslang's.
#pragma once

#include <string>

#include "shaders/compile.h"

namespace penumbra::preprocessing {

struct BothTexts {
  std::string own;
  std::string of_glslang;        // empty when it complains
  bool left_to_glslang = false;  // the project's own had no text, and `own` is glslang's as well
};

BothTexts both_texts(const shaders::CompileRequest& request);

// Reads a shader's text as `request.text`, with what it includes beside `request.file`.
BothTexts both_texts(const std::string& text);

}  // namespace penumbra::preprocessing
