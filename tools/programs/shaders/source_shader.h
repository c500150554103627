// A text prepared for glslang's front end. Internal to this folder.
#pragma once

#include <glslang/Public/ShaderLang.h>

#include "shaders/compile.h"
#include "shaders/parse_failure.h"

namespace penumbra::shaders {

inline constexpr int hlsl_version = 500;

// The inputs of a TShader. glslang keeps the pointers it is given, so this must outlive the TShader.
struct Source {
  const CompileRequest& request;
  std::string name;
  const std::string& text;
};

EShLanguage language(hlsl::Stage stage);
EShMessages messages_of(const CompileRequest& request);  // glslang's options

// A TShader with the request's settings, not parsed yet. glslang keeps the pointers it is given, including
// the arrays of pointers, so they are stored here and in the source, which must outlive this object.
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

// The input for diagnosing a failed parse or link; the source must outlive it.
ParseFailure failure_of(const Source& source, const std::string& log, const std::string& expanded);

}  // namespace penumbra::shaders
