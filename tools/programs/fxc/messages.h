// FXC's messages, at the places of the files that its text was expanded from.
#pragma once

#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"

namespace penumbra::fxc {

// The text for FXC: `expanded` without its #line directives, so that lines can be counted, and without the
// #pragmas that are Unity's own, about which FXC would warn. Lines and columns of everything else stay.
std::string text_for_fxc(const std::string& expanded);

// The messages about text_for_fxc(expanded), each once. "X3206: text" is the message; `sources` are the files
// that `expanded` was made of, whose first is `main_file`. A message without a place has that file and line
// 0.
std::vector<hlsl::Diagnostic> diagnostics_of(const std::string& messages, const std::string& expanded,
                                             const std::string& main_file, const hlsl::SourceFiles& sources);

}  // namespace penumbra::fxc
