// FXC's messages, at their places in the files from which its text was expanded.
#pragma once

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"

namespace penumbra::fxc {

// Returns the text for FXC: `expanded` without its #line directives, so that lines can be counted, and
// without the #pragmas that are Unity's own, about which FXC would warn. Lines and columns of everything else
// stay.
std::string text_for_fxc(const std::string& expanded);

// Returns the messages about text_for_fxc(expanded), each once. "X3206: text" is the message; `sources` are
// the files from which `expanded` was made, the first of them `main_file`. A message without a place has that
// file and line 0.
std::vector<hlsl::Diagnostic> diagnostics_of(const std::string& messages, const std::string& expanded,
                                             const std::string& main_file, const hlsl::SourceFiles& sources);

}  // namespace penumbra::fxc
