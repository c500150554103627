// A diagnostic: a message about a source text, at the location that has to be corrected.
#pragma once

#include <string>
#include <vector>

namespace penumbra::hlsl {

enum class Severity { note, warning, error };

struct Diagnostic {
  std::string file;
  int line = 0;    // 1-based; 0 when the message has no line
  int column = 0;  // 1-based; 0 when unknown
  Severity severity = Severity::error;
  std::string message;
  std::string source_line;  // the text of that line, for the caret
  std::string rule{};       // name of the lint rule that found it; empty for a compiler's message

  bool operator==(const Diagnostic&) const = default;
};

// Returns "file:line:column: error: message", the source line, and a caret under the column.
std::string format(const Diagnostic& diagnostic);

bool has_errors(const std::vector<Diagnostic>& diagnostics);
const Diagnostic* first_error(const std::vector<Diagnostic>& diagnostics);  // null if there is none

}  // namespace penumbra::hlsl
