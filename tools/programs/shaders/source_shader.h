// A text as glslang's front end takes it. Internal to this room.
#pragma once

#include <glslang/Public/ShaderLang.h>

#include <string>

#include "shaders/compile.h"
#include "shaders/parse_failure.h"

namespace penumbra::shaders {

inline constexpr int hlsl_version = 500;

// What a TShader is made of. glslang keeps the pointers it is given: all of it outlives the TShader.
struct Source {
  const CompileRequest& request;
  std::string name;
  const std::string& text;
  std::string preamble;  // #define lines that stand before the text and count as no lines
};

EShLanguage language(hlsl::Stage stage);
EShMessages messages_of(const CompileRequest& request);  // glslang's options

// A TShader with everything of the request set but not parsed. glslang keeps the pointers it is given, the
// arrays of pointers included, so they stand here beside it and in the source, which outlives both.
class SourceShader {
 public:
  explicit SourceShader(const Source& source);
  SourceShader(const SourceShader&) = delete;
  SourceShader& operator=(const SourceShader&) = delete;

  glslang::TShader& get() { return shader_; }

 private:
  const char* texts_[1];
  const char* names_[1];
  int lengths_[1];
  glslang::TShader shader_;
};

// What the diagnosis of a parse or a link that failed may draw on; the source outlives it.
ParseFailure failure_of(const Source& source, const std::string& log, const std::string& expanded);

}  // namespace penumbra::shaders
