// Compiles variants whose texts share most of their declarations.
//
// A variant of a pipeline's shader reaches a quarter of the functions in its includes. The rest is checked
// only once: the parser's diagnostics of a declaration are cached under a key of everything that it depends
// on (hlsl/reach.h), and reported again for every text with that key. The module is compiled from the reached
// declarations, so it does not depend on earlier compilations; nor do the diagnostics. A text with an error
// is compiled as a whole.
//
// The reached declarations are often the same: keywords and graphics APIs mostly change code that an entry
// point does not use. Equal reached texts are compiled once. Not thread-safe.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "hlsl/reach.h"
#include "shaders/compile.h"
#include "validation/recent_results.h"
#include "validation/unit.h"

namespace penumbra::validation {

// An object is not for several threads at once.
class CheckedDeclarations {
 public:
  // The result is that of shaders::compile() of the prepared source. `expanded` has no errors yet.
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
  // The results by reached text, before and after its preparation, which makes more of them equal. Each takes
  // a tenth of a megabyte.
  RecentResults<shaders::CompileResult> reached_{64};
  RecentResults<shaders::CompileResult> prepared_{64};
};

// Compiles the whole text, including unreached declarations: the results are equal, but it takes longer.
shaders::CompileResult compile_whole(const shaders::CompileRequest& request,
                                     shaders::PreprocessedSource expanded);

}  // namespace penumbra::validation
