#include "shaders/parse_failure.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "hlsl/identifier.h"

namespace penumbra::shaders {

namespace {

// A line of the log: "ERROR: file:line: 'token' : message".
struct LogLine {
  hlsl::Severity severity = hlsl::Severity::error;
  std::string file;
  int line = 0;
  std::string token;
  std::string message;
};

struct Prefix {
  std::string_view text;
  hlsl::Severity severity;
};
constexpr std::array<Prefix, 4> prefixes{{{"ERROR: ", hlsl::Severity::error},
                                          {"INTERNAL ERROR: ", hlsl::Severity::error},
                                          {"UNIMPLEMENTED: ", hlsl::Severity::error},
                                          {"WARNING: ", hlsl::Severity::warning}}};

// Takes ":123: " off the front of `rest`.
bool take_line_number(std::string_view& rest, int& line) {
  std::size_t end = 1;
  while (end < rest.size() && std::isdigit(static_cast<unsigned char>(rest[end])) != 0 && end < 9) ++end;
  if (rest.empty() || rest[0] != ':' || end == 1 || rest.substr(end, 2) != ": ") return false;
  line = std::stoi(std::string(rest.substr(1, end - 1)));
  rest.remove_prefix(end + 2);
  return true;
}

// The file name may contain colons and spaces, so it is compared with the files of this compilation, longest
// first.
void take_place(std::string_view& rest, const hlsl::SourceFiles& sources, LogLine& out) {
  std::vector<std::string> names = sources.names();
  std::sort(names.begin(), names.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  for (const std::string& name : names) {
    if (!rest.starts_with(name)) continue;
    std::string_view after = rest.substr(name.size());
    if (!take_line_number(after, out.line)) continue;
    out.file = name;
    rest = after;
    return;
  }
}

// The form is "'token' : message"; the token may contain quotes.
void take_token(std::string_view& rest, LogLine& out) {
  const std::size_t end = rest.find("' : ");
  if (rest.empty() || rest[0] != '\'' || end == std::string_view::npos) return;
  out.token = rest.substr(1, end - 1);
  rest.remove_prefix(end + 4);
}

// "@Main" is glslang's name of the entry point Main, "__BI_Sample" that of the method Sample.
std::string as_written(std::string text) {
  for (const std::string_view added : {"@", "__BI_"})
    for (std::size_t at = text.find(added); at != std::string::npos; at = text.find(added, at + 1))
      if (at + added.size() < text.size() && hlsl::continues_identifier(text[at + added.size()]))
        text.erase(at, added.size());
  return text;
}

// The messages of a log without lines, as one text.
std::string in_one_line(std::string_view log) {
  std::string text;
  std::istringstream words{std::string(log)};
  for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
  return as_written(text);
}

std::vector<LogLine> parse_log(std::string_view log, const hlsl::SourceFiles& sources) {
  std::vector<LogLine> lines;
  std::istringstream stream{std::string(log)};
  for (std::string text; std::getline(stream, text);) {
    for (const Prefix& prefix : prefixes) {
      if (!text.starts_with(prefix.text)) continue;
      LogLine line;
      line.severity = prefix.severity;
      std::string_view rest = std::string_view(text).substr(prefix.text.size());
      take_place(rest, sources, line);
      take_token(rest, line);
      while (!rest.empty() && rest.back() == ' ') rest.remove_suffix(1);
      while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
      line.token = as_written(line.token);
      line.message = as_written(std::string(rest));
      lines.push_back(line);
    }
  }
  return lines;
}

const LogLine* first_error_line(const std::vector<LogLine>& lines) {
  const auto error = std::find_if(lines.begin(), lines.end(),
                                  [](const LogLine& line) { return line.severity == hlsl::Severity::error; });
  return error == lines.end() ? nullptr : &*error;
}

// The parser says what it "Expected" as the token.
std::string sentence(const LogLine& line) {
  if (line.message == "Expected") return "expected '" + line.token + "'";
  if (line.token.empty()) return line.message;
  const bool after = hlsl::is_identifier(line.token) || line.message == "unexpected token";
  return after ? line.message + " '" + line.token + "'" : "'" + line.token + "': " + line.message;
}

hlsl::Diagnostic at_line(const LogLine& line, const hlsl::SourceFiles& sources) {
  const std::string text = sources.line(line.file, line.line);
  const int column = line.message == "Expected" ? 0 : hlsl::column_of_word(line.token, text);
  return {line.file, line.line, column, line.severity, sentence(line), text};
}

hlsl::Diagnostic at_place(const hlsl::TokenPlace& place, std::string message,
                          const hlsl::SourceFiles& sources) {
  return {place.file,         place.line,
          place.column,       hlsl::Severity::error,
          std::move(message), sources.line(place.file, place.line)};
}

// Returns the index of the token that the parser reported; size() if it now reports another error.
std::size_t find_token(const ParseFailure& failure, const LogLine& error, const hlsl::TokenPlaces& places,
                       const hlsl::SourceFiles& sources) {
  if (!failure.log_of || places.size() == 0) return places.size();
  const std::vector<LogLine> lines = parse_log(failure.log_of(places.one_per_line()), sources);
  const LogLine* again = first_error_line(lines);
  const bool same = again != nullptr && again->message == error.message && again->token == error.token;
  return same && again->line >= 1 ? std::min(static_cast<std::size_t>(again->line) - 1, places.size())
                                  : places.size();
}

hlsl::Diagnostic at_token(const LogLine& error, std::size_t at, const hlsl::TokenPlaces& places,
                          const hlsl::SourceFiles& sources) {
  // A missing ';' or ',' is detected at the next token, often a line or a file later.
  const bool separator =
      at > 0 && (error.token == ";" || (error.token == "," && !places.same_line(at - 1, at)));
  if (error.message == "Expected" && separator)
    return at_place(places.after(at - 1, sources), sentence(error), sources);
  hlsl::TokenPlace place = places.at(at, sources);
  if (error.message == "Expected")
    return at_place(place, sentence(error) + ", found '" + std::string(places[at].spelling) + "'", sources);
  if (place.file == error.file && place.line == error.line)
    if (const int column = hlsl::column_of_word(error.token, sources.line(error.file, error.line));
        column != 0)
      place.column = column;
  return at_place(place, sentence(error), sources);
}

// The text "Fade(f1;" is glslang's name of a function with its parameters' types.
std::string_view last_function(std::string_view log) {
  const std::size_t end = std::min(log.rfind('('), log.size());
  std::size_t begin = end;
  while (begin > 0 && hlsl::continues_identifier(log[begin - 1])) --begin;
  return log.substr(begin, end - begin);
}

// Without messages, the log may begin "file(6): error at column 1, HLSL parsing failed."
hlsl::Diagnostic given_up(const ParseFailure& failure, const hlsl::SourceFiles& sources) {
  for (const std::string& name : sources.names())
    if (failure.log.starts_with(name + "("))
      return at_place({name, std::atoi(std::string(failure.log.substr(name.size() + 1)).c_str()), 0},
                      "the HLSL front end cannot read on from here", sources);
  return at_place({failure.main_file, 0, 0}, "the HLSL front end gave up: " + in_one_line(failure.log),
                  sources);
}

}  // namespace

bool has_error(std::string_view log, const hlsl::SourceFiles& sources) {
  return first_error_line(parse_log(log, sources)) != nullptr;
}

hlsl::Diagnostic first_error(const ParseFailure& failure, const hlsl::SourceFiles& sources) {
  const std::vector<LogLine> lines = parse_log(failure.log, sources);
  const LogLine* error = first_error_line(lines);
  if (error == nullptr || error->line == 0) return given_up(failure, sources);
  const hlsl::TokenPlaces places(failure.preprocessed, failure.main_file);
  const std::size_t at = find_token(failure, *error, places, sources);
  return at < places.size() ? at_token(*error, at, places, sources) : at_line(*error, sources);
}

hlsl::Diagnostic link_error(const ParseFailure& failure, const NamedEntry& entry,
                            const hlsl::SourceFiles& sources) {
  hlsl::TokenPlace place{failure.main_file, 0, 0};
  if (failure.log.find("Entry point not found") != std::string_view::npos)
    return at_place(entry.place.line > 0 ? entry.place : place,
                    "the entry point '" + entry.name + "' is not defined", sources);
  const hlsl::TokenPlaces places(failure.preprocessed, failure.main_file);
  const std::size_t at = places.function(last_function(failure.log));
  if (at < places.size()) place = places.at(at, sources);
  return at_place(place, "link: " + in_one_line(failure.log), sources);
}

std::vector<hlsl::Diagnostic> warnings(std::string_view log, const hlsl::SourceFiles& sources) {
  std::vector<hlsl::Diagnostic> diagnostics;
  std::vector<std::string> seen;
  for (const LogLine& line : parse_log(log, sources)) {
    if (line.severity != hlsl::Severity::warning) continue;
    const hlsl::Diagnostic diagnostic = at_line(line, sources);
    if (std::find(seen.begin(), seen.end(), format(diagnostic)) != seen.end()) continue;
    seen.push_back(format(diagnostic));
    diagnostics.push_back(diagnostic);
  }
  return diagnostics;
}

}  // namespace penumbra::shaders
