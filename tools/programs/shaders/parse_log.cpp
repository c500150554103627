#include "shaders/parse_log.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "hlsl/identifier.h"

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

// Takes ":123: " (or "(123): ") off the front of `rest`.
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

// "@Main" is glslang's name of the entry point Main.
std::string as_written(std::string_view message) {
  std::string written;
  for (std::size_t at = 0; at < message.size(); ++at)
    if (message[at] != '@' || at + 1 == message.size() || !hlsl::continues_identifier(message[at + 1]))
      written += message[at];
  return written;
}

}  // namespace

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
      line.message = as_written(rest);
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
        (at > 0 && hlsl::continues_identifier(line[at - 1]) && hlsl::continues_identifier(token.front())) ||
        (at + token.size() < line.size() && hlsl::continues_identifier(line[at + token.size()]) &&
         hlsl::continues_identifier(token.back()));
    if (inside_word) continue;
    if (column != 0) return 0;
    column = static_cast<int>(at) + 1;
  }
  return column;
}

}  // namespace penumbra::shaders
