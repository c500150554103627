#include "shaders/bad_character.h"

#include <algorithm>
#include <string_view>

#include "hlsl/expanded_text.h"

namespace penumbra::shaders {

namespace {

constexpr std::string_view printed_for_it = "<bad token>";

bool begins_a_token(char c) {
  constexpr std::string_view marks = " \t_()[]{}<>.,;:?!~^&|+-*/%=\"'#\\";
  const bool word = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return word || marks.find(c) != std::string_view::npos;
}

// All bytes of the UTF-8 character that begins here.
std::string whole_character(std::string_view line, std::size_t at) {
  std::size_t end = at + 1;
  while (end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) ++end;
  return std::string(line.substr(at, end - at));
}

}  // namespace

std::optional<hlsl::Diagnostic> bad_character(const std::string& preprocessed, const std::string& main_file,
                                              const hlsl::SourceFiles& sources) {
  if (preprocessed.find(printed_for_it) == std::string::npos) return std::nullopt;
  const std::vector<hlsl::CodeLine> lines = hlsl::expanded_lines(preprocessed);
  const auto line = std::find_if(lines.begin(), lines.end(), [](const hlsl::CodeLine& code) {
    return code.text.find(printed_for_it) != std::string::npos;
  });
  if (line == lines.end()) return std::nullopt;
  const std::string file = line->file.empty() ? main_file : line->file;
  const std::string text = sources.line(file, line->line);
  hlsl::Diagnostic diagnostic{file, line->line, 0, hlsl::Severity::error, {}, text};
  const std::size_t end = std::min(text.find("//"), text.size());
  for (std::size_t at = 0; at < end; ++at) {
    if (begins_a_token(text[at])) continue;
    diagnostic.column = static_cast<int>(at) + 1;
    diagnostic.message = "unexpected token '" + whole_character(text, at) + "'";
    return diagnostic;
  }
  diagnostic.message = "a character here, or in a macro used here, is none of HLSL's";
  return diagnostic;
}

}  // namespace penumbra::shaders
