// The text of one variant as the parser reads it: after includes, macros and preparation, every line with its
// origin.
#pragma once

#include <string>

#include "validation/engine.h"
#include "validation/unit.h"

namespace penumbra::validation {

// The text is self-contained HLSL: comments give the file, and before each line its number there; empty lines
// are omitted. If errors occur before there is a text, they are in `diagnostics`, and the text is empty.
struct Explanation {
  std::string text;
  std::vector<hlsl::Diagnostic> diagnostics;
};

// It runs in a worker process if the options name one. Throws EnvironmentError if it is not available.
Explanation explain(const CompileUnit& unit, const EngineOptions& options);

// Returns "/* 12 */ code", with a comment where the file changes. `main_file` names what stands before any
// #line.
std::string with_origins(const std::string& preprocessed, const std::string& main_file);

}  // namespace penumbra::validation
