// Compiles variants whose texts have most of their declarations in common.
//
// A variant of a pipeline's shader reaches a quarter of the functions that its includes bring. The rest is
// looked at, but once: what the parser says of a declaration is kept under a key of all that it rests on
// (hlsl/reach.h), and said again wherever that key comes back. The module is made of what is reached, so that
// it does not depend on what came before; nor do the messages, which for a text with an error are those of
// the whole text.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "hlsl/reach.h"
#include "shaders/compile.h"

namespace penumbra::validation {

// Not for several threads at once.
class CheckedDeclarations {
 public:
  // As shaders::compile() of the prepared source. `expanded` has no errors yet.
  shaders::CompileResult compile(const shaders::CompileRequest& request,
                                 shaders::PreprocessedSource expanded);

 private:
  std::vector<std::size_t> unknown(const hlsl::Reach& reach, const std::string& circumstances) const;
  void learn(const hlsl::Reach& reach, const std::string& circumstances,
             const std::vector<hlsl::Diagnostic>& said, const std::vector<std::size_t>& checked);

  std::unordered_map<std::string, std::vector<hlsl::Diagnostic>> known_;
};

// How the whole text is compiled, unreached declarations included; equal in everything but time.
shaders::CompileResult compile_whole(const shaders::CompileRequest& request,
                                     shaders::PreprocessedSource expanded);

}  // namespace penumbra::validation
