// The preparation of preprocessed HLSL for glslang's front end: HLSL that Unity's compilers accept and
// glslang does not is rewritten to equivalent code.
//
// Each incompatibility is one pass over the tokens (passes.h); none depends on a project's names. Every token
// keeps its original line. docs/validating.md lists them.
#pragma once

#include <span>

#include "hlsl/diagnostic.h"
#include "preparation/semantic_names.h"
#include "preparation/source_checks.h"
#include "preparation/token_text.h"

namespace penumbra::preparation {

struct Pass {
  const char* name;  // name in the documentation
  void (*run)(TokenText&);
};

// The passes are in execution order.
std::span<const Pass> passes();

struct PreparedShader {
  std::string text;  // has #line directives
  std::vector<Note> notes;
  std::vector<SemanticPlace> semantics{};  // semantics of the entry point
};

// `preprocessed` has no comments and no macros, but #line directives. Lines before the first #line are in
// `main_file`. With an entry point the source is checked as well (source_checks.h).
PreparedShader prepare(std::string preprocessed, const std::string& main_file,
                       const std::optional<EntryPoint>& entry = std::nullopt);

}  // namespace penumbra::preparation
