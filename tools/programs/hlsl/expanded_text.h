// Reads preprocessed text line by line with its origin, to report where a bracket was left open: the parser
// only notices later, often in another file. Internal to this folder.
#pragma once

#include <optional>

#include "hlsl/source_text.h"

namespace penumbra::hlsl {

struct CodeLine {
  std::string file;
  int line = 0;
  std::string text;
};

struct OpenPlace {
  std::string file;
  int line = 0;
  int column = 0;
  std::string token;
  std::string message;
};

// Splits preprocessor output at its #line directives; lines before the first belong to `main_file`.
std::vector<CodeLine> expanded_lines(const std::string& preprocessed, const std::string& main_file);

// Finds a bracket that is never closed, closed by another kind, or closed without having been opened. If
// several braces are open, it reports the one whose '}' seems to have closed another: the first that is
// closed further left than the line that opened it.
std::optional<OpenPlace> unbalanced_bracket(const std::vector<CodeLine>& lines, const SourceFiles& sources);

// Up to this many empty lines are shorter than a #line directive.
inline constexpr int most_empty_lines = 16;

// Returns preprocessed text without its empty lines, with a #line directive only where one is needed: the
// same code at the same locations gives the same text, whatever was removed between. Each token keeps its
// file, line and column.
std::string dense_lines(std::string_view preprocessed);

}  // namespace penumbra::hlsl
