// One variant as the parser reads it: includes, macros and preparation done, every line with its origin.
#pragma once

#include <string>

#include "validation/engine.h"
#include "validation/unit.h"

namespace penumbra::validation {

// HLSL that compiles by itself: comments give the file, and before each line its number there; empty lines
// are left out. What fails before there is a text is in `diagnostics`, and the text is empty.
struct Explanation {
  std::string text;
  std::vector<hlsl::Diagnostic> diagnostics;
};

// In a worker process where the options name one. Throws EnvironmentError when none is to be had.
Explanation explain(const CompileUnit& unit, const EngineOptions& options);

// "/* 12 */ code" and a comment where the file changes. `main_file` names what stands before any #line.
std::string with_origins(const std::string& preprocessed, const std::string& main_file);

}  // namespace penumbra::validation
