#include "hlsl/diagnostic.h"

#include <algorithm>

#include "input/visible_text.h"

namespace penumbra::hlsl {

namespace {

const char* severity_name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      break;
  }
  return "error";
}

// Blanks up to the column, tabs kept, so that the caret stands under its character at any tab width.
std::string blanks_before(const std::string& line, int column) {
  std::string blanks;
  for (int i = 0; i + 1 < column; ++i)
    blanks +=
        static_cast<std::size_t>(i) < line.size() && line[static_cast<std::size_t>(i)] == '\t' ? '\t' : ' ';
  return blanks;
}

}  // namespace

std::string format(const Diagnostic& diagnostic) {
  std::string text = visible(diagnostic.file);
  if (diagnostic.line > 0) text += ":" + std::to_string(diagnostic.line);
  if (diagnostic.line > 0 && diagnostic.column > 0) text += ":" + std::to_string(diagnostic.column);
  if (!text.empty()) text += ": ";
  text += std::string(severity_name(diagnostic.severity)) + ": " + visible(diagnostic.message);
  if (diagnostic.line == 0 || diagnostic.source_line.empty()) return text;
  const std::string_view line = diagnostic.source_line;
  text += "\n    " + visible_line(line);
  if (diagnostic.column > 0) {
    // Escapes are wider than what they stand for.
    const std::size_t before = std::min(line.size(), static_cast<std::size_t>(diagnostic.column - 1));
    const std::string shown = visible_line(line.substr(0, before));
    const std::size_t beyond = static_cast<std::size_t>(diagnostic.column - 1) - before;
    text += "\n    " + blanks_before(shown, static_cast<int>(shown.size() + beyond) + 1) + "^";
  }
  return text;
}

bool has_errors(const std::vector<Diagnostic>& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::error; });
}

}  // namespace penumbra::hlsl
