// Compiles variants whose texts have most of their declarations in common.
//
// A variant of a pipeline's shader reaches a quarter of the functions that its includes bring. The rest is
// looked at, but once: what the parser says of a declaration is kept under a key of all that it rests on
// (hlsl/reach.h), and said again wherever that key comes back. The module is made of what is reached, so that
// it does not depend on what came before; nor do the messages, which for a text with an error are those of
// the whole text.
//
// What is reached is often the same: keywords and graphics APIs mostly change code that an entry point does
// not use. Equal reached texts are compiled once.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "hlsl/reach.h"
#include "shaders/compile.h"
#include "validation/recent_results.h"
#include "validation/sharing.h"

namespace penumbra::validation {

// Not for several threads at once.
class CheckedDeclarations {
 public:
  // As shaders::compile() of the prepared source. `expanded` has no errors yet.
  shaders::CompileResult compile(const shaders::CompileRequest& request, shaders::PreprocessedSource expanded,
                                 Sharing sharing = Sharing::everything);

 private:
  std::vector<std::size_t> unknown(const hlsl::Reach& reach, const std::string& circumstances) const;
  void learn(const hlsl::Reach& reach, const std::string& circumstances,
             const std::vector<hlsl::Diagnostic>& said, const std::vector<std::size_t>& checked);
  shaders::CompileResult compile_reached(const shaders::CompileRequest& request,
                                         shaders::PreprocessedSource reached, Sharing sharing);
  shaders::CompileResult compile_prepared(const shaders::CompileRequest& request,
                                          shaders::PreprocessedSource prepared);

  std::unordered_map<std::string, std::vector<hlsl::Diagnostic>> known_;
  // By reached text, before and after its preparation, which evens out more: a tenth of a megabyte each.
  RecentResults<shaders::CompileResult> reached_{64};
  RecentResults<shaders::CompileResult> prepared_{64};
};

// How the whole text is compiled, unreached declarations included; equal in everything but time.
shaders::CompileResult compile_whole(const shaders::CompileRequest& request,
                                     shaders::PreprocessedSource expanded);

}  // namespace penumbra::validation
