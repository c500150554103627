// The rules for a single compiled shader stage: derivatives and barriers in divergent control flow, group
// shared memory, samplers, limits.
//
// Compile with CompileRequest::optimise off and debug_lines on, and pass the result's SPIR-V and sources.
// Findings are sorted by file and line, each once, without those that a comment suppresses (suppression.h).
// Does not throw for a module that glslang produced; std::invalid_argument for words that are not SPIR-V.
// Reentrant. The work is bounded: modules with more than 4,000 basic blocks, also after inlining, are
// reported by a note (rule not-checked) and not analysed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"
#include "hlsl/stage.h"

namespace penumbra::lint {

struct ModuleToLint {
  std::vector<std::uint32_t> spirv;  // unoptimised, with debug lines
  hlsl::Stage stage = hlsl::Stage::fragment;
  std::string file;           // the main file, for findings with no line
  hlsl::SourceFiles sources;  // see CompileResult::sources
  // The shader target is ten times `#pragma target` (25, 30, 35, 45, 50); 0 if none was given.
  int shader_target = 0;
  // The legalised SPIR-V, if the compiler has produced it: with it, a check whether there is anything to
  // report is faster. It is empty if not available.
  std::vector<std::uint32_t> legalised{};
};

std::vector<hlsl::Diagnostic> lint_module(const ModuleToLint& module);

// These are the two steps: the findings of the module, equal for equal modules, and their filtering by the
// comments in the texts.
std::vector<hlsl::Diagnostic> module_findings(const ModuleToLint& module);
std::vector<hlsl::Diagnostic> with_suppressions(std::vector<hlsl::Diagnostic> findings,
                                                const hlsl::SourceFiles& sources);

}  // namespace penumbra::lint
