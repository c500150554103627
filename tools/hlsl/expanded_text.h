// Reads what the preprocessor left, line by line with its origin, to say where a bracket, a condition or a
// statement was left open: the parser only notices later, often in another file. Internal to this room.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

// Splits preprocessor output at its #line directives.
std::vector<CodeLine> expanded_lines(const std::string& preprocessed);

// A bracket that is never closed, closed by another kind, or closed without having been opened.
std::optional<OpenPlace> unbalanced_bracket(const std::vector<CodeLine>& lines);

// An #if without #endif, or the other way round, within one file.
std::optional<OpenPlace> open_condition(const SourceFiles& sources);

// The last line with code before the given one, when no ';', bracket or comma ends it.
std::optional<CodeLine> unfinished_line_before(const std::vector<CodeLine>& lines, const std::string& file,
                                               int line);

// 1-based column just after the last character that is neither blank nor a // comment.
int column_after_code(std::string_view line);

}  // namespace penumbra::hlsl
