// The rules that one compiled shader stage decides by itself: unset outputs and variables, derivatives in
// varying control flow, unbounded [unroll], pow of negative bases, NaN tests, samplers, limits.
//
// Compile with CompileRequest::optimise off and debug_lines on, and hand over the result's SPIR-V and
// sources. Findings come in the order of files and lines, each once, without those a comment suppresses
// (suppression.h). Never throws for a module that glslang made; std::invalid_argument for words that are no
// SPIR-V. Reentrant. Work is bounded: what has more than 4,000 basic blocks is named in a note (rule
// not-checked) and not followed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hlsl/source_text.h"
#include "hlsl/stage.h"
#include "lint/rule.h"

namespace penumbra::lint {

struct ModuleToLint {
  std::vector<std::uint32_t> spirv;  // unoptimised, with debug lines
  hlsl::Stage stage = hlsl::Stage::fragment;
  std::string file;           // the main file, for findings with no line
  hlsl::SourceFiles sources;  // as CompileResult has them
  // Ten times `#pragma target` (25, 30, 35, 45, 50); 0: none was given.
  int shader_target = 0;
  // The SPIR-V legalised, where the compiler has it at hand: whether there is anything to report is then told
  // sooner. Empty: not at hand.
  std::vector<std::uint32_t> legalised{};
};

std::vector<Finding> lint_module(const ModuleToLint& module);

// The two halves of it: what the module shows, of which equal modules show the same, and what the comments of
// the texts make of that.
std::vector<Finding> module_findings(const ModuleToLint& module);
std::vector<Finding> with_suppressions(std::vector<Finding> findings, const hlsl::SourceFiles& sources);

}  // namespace penumbra::lint
