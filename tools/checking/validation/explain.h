// One variant as the parser reads it: after includes, macros and preparation, every line with its origin.
#pragma once

#include <string>

#include "validation/engine.h"
#include "validation/unit.h"

namespace penumbra::validation {

// Self-contained HLSL: comments give the file, and before each line its number there; empty lines are
// omitted. Errors before there is a text are in `diagnostics`, and the text is empty.
struct Explanation {
  std::string text;
  std::vector<hlsl::Diagnostic> diagnostics;
};

// In a worker process if the options name one. Throws EnvironmentError if it is not available.
Explanation explain(const CompileUnit& unit, const EngineOptions& options);

// "/* 12 */ code" and a comment where the file changes. `main_file` names what stands before any #line.
std::string with_origins(const std::string& preprocessed, const std::string& main_file);

}  // namespace penumbra::validation
