#include "shaders/parse_failure.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "hlsl/expanded_text.h"

namespace penumbra::shaders {

namespace {

struct Prefix {
  std::string_view text;
  hlsl::Severity severity;
};
constexpr std::array<Prefix, 4> prefixes{{{"ERROR: ", hlsl::Severity::error},
                                          {"INTERNAL ERROR: ", hlsl::Severity::error},
                                          {"UNIMPLEMENTED: ", hlsl::Severity::error},
                                          {"WARNING: ", hlsl::Severity::warning}}};

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Takes ":123: " (or "(123): ") off the front of `rest`.
bool take_line_number(std::string_view& rest, int& line) {
  std::size_t end = 1;
  while (end < rest.size() && std::isdigit(static_cast<unsigned char>(rest[end])) != 0 && end < 9) ++end;
  if (rest.empty() || rest[0] != ':' || end == 1 || rest.substr(end, 2) != ": ") return false;
  line = std::stoi(std::string(rest.substr(1, end - 1)));
  rest.remove_prefix(end + 2);
  return true;
}

// The file may hold colons and blanks: it is found by the names this compilation has read, longest first.
void take_place(std::string_view& rest, const hlsl::SourceFiles& sources, LogLine& out) {
  std::vector<std::string> names = sources.names();
  std::sort(names.begin(), names.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  for (const std::string& name : names) {
    if (!starts_with(rest, name)) continue;
    std::string_view after = rest.substr(name.size());
    if (!take_line_number(after, out.line)) continue;
    out.file = name;
    rest = after;
    return;
  }
}

// "'token' : message"; the token may hold quotes.
void take_token(std::string_view& rest, LogLine& out) {
  const std::size_t end = rest.find("' : ");
  if (rest.empty() || rest[0] != '\'' || end == std::string_view::npos) return;
  out.token = rest.substr(1, end - 1);
  rest.remove_prefix(end + 4);
}

std::string without(std::string text, const std::string& part, const std::string& instead) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + instead.size()))
    text.replace(at, part.size(), instead);
  return text;
}

bool is_name(const std::string& token) {
  return !token.empty() && std::all_of(token.begin(), token.end(), is_word);
}

// glslang gives the token first and then what is wrong with it; a name reads better at the end.
std::string sentence(const LogLine& line) {
  if (line.message == "Expected") return "expected '" + line.token + "'";
  std::string message = without(without(line.message, "from ' ", "from '"), "to ' ", "to '");
  if (line.token.empty()) return message;
  if (is_name(line.token) || message == "unexpected token") return message + " '" + line.token + "'";
  return "'" + line.token + "': " + message;
}

hlsl::Diagnostic to_diagnostic(const LogLine& line, const hlsl::SourceFiles& sources) {
  const std::string text = sources.line(line.file, line.line);
  if (line.message == "End of input in comment") {
    const auto column = static_cast<int>(text.rfind("/*") + 1);  // 0 when it is not there
    return {line.file, line.line, column, line.severity, "'/*' is never closed", text};
  }
  const int column = line.message == "Expected" ? 0 : column_of(line.token, text);
  return {line.file, line.line, column, line.severity, sentence(line), text};
}

hlsl::Diagnostic at_end_of(const hlsl::CodeLine& code, const std::string& message,
                           const hlsl::SourceFiles& sources) {
  const std::string text = sources.line(code.file, code.line);
  return {code.file, code.line, hlsl::column_after_code(text), hlsl::Severity::error, message, text};
}

// A missing ';' or ')' is noticed at the next token, often a line or a file later; it is mended where the
// code before that token ends.
hlsl::Diagnostic place_expected(const LogLine& line, const std::vector<hlsl::CodeLine>& code,
                                const hlsl::SourceFiles& sources) {
  const std::optional<hlsl::CodeLine> before = hlsl::unfinished_line_before(code, line.file, line.line);
  return before && line.token == ";" ? at_end_of(*before, sentence(line), sources)
                                     : to_diagnostic(line, sources);
}

}  // namespace

std::vector<LogLine> parse_log(std::string_view log, const hlsl::SourceFiles& sources) {
  std::vector<LogLine> lines;
  std::istringstream stream{std::string(log)};
  for (std::string text; std::getline(stream, text);) {
    for (const Prefix& prefix : prefixes) {
      if (!starts_with(text, prefix.text)) continue;
      LogLine line;
      line.severity = prefix.severity;
      std::string_view rest = std::string_view(text).substr(prefix.text.size());
      take_place(rest, sources, line);
      take_token(rest, line);
      while (!rest.empty() && rest.back() == ' ') rest.remove_suffix(1);
      while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
      line.message = rest;
      lines.push_back(line);
    }
  }
  return lines;
}

int column_of(std::string_view token, std::string_view line) {
  if (token.empty()) return 0;
  int column = 0;
  for (std::size_t at = line.find(token); at != std::string_view::npos; at = line.find(token, at + 1)) {
    const bool inside_word =
        (at > 0 && is_word(line[at - 1]) && is_word(token.front())) ||
        (at + token.size() < line.size() && is_word(line[at + token.size()]) && is_word(token.back()));
    if (inside_word) continue;
    if (column != 0) return 0;
    column = static_cast<int>(at) + 1;
  }
  return column;
}

hlsl::Diagnostic first_error(const ParseFailure& failure, const hlsl::SourceFiles& sources) {
  const std::vector<LogLine> lines = parse_log(failure.log, sources);
  const auto error = std::find_if(lines.begin(), lines.end(),
                                  [](const LogLine& line) { return line.severity == hlsl::Severity::error; });
  const std::vector<hlsl::CodeLine> code = hlsl::expanded_lines(failure.preprocessed);
  if (error != lines.end() && failure.include_failure) {
    LogLine line = *error;
    line.token.clear();
    line.message = *failure.include_failure;
    hlsl::Diagnostic diagnostic = to_diagnostic(line, sources);
    diagnostic.column = column_of("#include", diagnostic.source_line);
    return diagnostic;
  }
  // Before anything the parser says about it: a bracket or condition that a file leaves open.
  if (const std::optional<hlsl::OpenPlace> open = hlsl::open_condition(sources))
    return {open->file,    open->line,
            open->column,  hlsl::Severity::error,
            open->message, sources.line(open->file, open->line)};
  const bool vague = error == lines.end() || error->message == "Expected" || error->line == 0;
  if (vague) {
    if (const std::optional<hlsl::OpenPlace> open = hlsl::unbalanced_bracket(code)) {
      const std::string text = sources.line(open->file, open->line);
      return {open->file,    open->line, column_of(open->token, text), hlsl::Severity::error,
              open->message, text};
    }
  }
  if (error == lines.end() || error->line == 0)
    return {failure.main_file,
            0,
            0,
            hlsl::Severity::error,
            "the HLSL front end gave up: " + std::string(failure.log),
            {}};
  return error->message == "Expected" ? place_expected(*error, code, sources)
                                      : to_diagnostic(*error, sources);
}

std::vector<hlsl::Diagnostic> warnings(std::string_view log, const hlsl::SourceFiles& sources) {
  std::vector<hlsl::Diagnostic> diagnostics;
  std::vector<std::string> seen;
  for (const LogLine& line : parse_log(log, sources)) {
    if (line.severity != hlsl::Severity::warning) continue;
    const hlsl::Diagnostic diagnostic = to_diagnostic(line, sources);
    if (std::find(seen.begin(), seen.end(), format(diagnostic)) != seen.end()) continue;
    seen.push_back(format(diagnostic));
    diagnostics.push_back(diagnostic);
  }
  return diagnostics;
}

}  // namespace penumbra::shaders
