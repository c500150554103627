#include "preprocessing/both_preprocessors.h"

#include "shaders/source_memory.h"

namespace penumbra::preprocessing {

BothTexts both_texts(const shaders::CompileRequest& request) {
  shaders::SourceMemory own;
  shaders::SourceMemory glslang(true);
  BothTexts both;
  both.own = shaders::expand(request, own).text;
  both.of_glslang = shaders::expand(request, glslang).text;
  both.left_to_glslang = own.left_to_glslang() != 0;
  return both;
}

BothTexts both_texts(const std::string& text) {
  shaders::CompileRequest request;
  request.file = "main.hlsl";
  request.text = text;
  request.prepare = true;
  return both_texts(request);
}

}  // namespace penumbra::preprocessing
