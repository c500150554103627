// The preparation of preprocessed HLSL for glslang's front end: what Unity's compilers accept and it does not
// is rewritten to code of the same meaning.
//
// Each obstacle is one pass over the tokens, in a file of its own that says what it looks for, what it puts
// there and why the meaning stays; none knows any project's names. Every token keeps the line it came from.
// Documentation~/preparation.md has one line for each.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "preparation/source_checks.h"
#include "preparation/token_text.h"

namespace penumbra::preparation {

struct Pass {
  const char* name;  // as the documentation calls it
  void (*run)(TokenText&);
};

// In the order they run in.
std::span<const Pass> passes();

struct PreparedShader {
  std::string text;  // with #line directives
  std::vector<Note> notes;
};

// `preprocessed`: no comments, no macros, #line directives. Lines before the first #line are in `main_file`.
// With an entry point the source is checked as well (source_checks.h).
PreparedShader prepare(std::string preprocessed, const std::string& main_file,
                       const std::optional<EntryPoint>& entry = std::nullopt);

}  // namespace penumbra::preparation
