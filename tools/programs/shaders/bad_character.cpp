#include "shaders/bad_character.h"

#include <algorithm>
#include <cstdio>
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

// Returns the character that begins here, or its byte value if it is not valid UTF-8.
std::string in_words(std::string_view line, std::size_t at) {
  std::size_t end = at + 1;
  while (end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) ++end;
  const auto lead = static_cast<unsigned char>(line[at]);
  const std::size_t length = lead >= 0xF0U ? 4 : lead >= 0xE0U ? 3 : lead >= 0xC2U ? 2 : 1;
  if (lead < 0x80U || (length > 1 && end - at == length))
    return "unexpected token '" + std::string(line.substr(at, end - at)) + "'";
  char byte[48];
  std::snprintf(byte, sizeof byte, "unexpected byte 0x%02X; is this file UTF-8?",
                static_cast<unsigned>(lead));
  return byte;
}

}  // namespace

std::optional<hlsl::Diagnostic> bad_character(const std::string& preprocessed, const std::string& main_file,
                                              const hlsl::SourceFiles& sources) {
  if (preprocessed.find(printed_for_it) == std::string::npos) return std::nullopt;
  const std::vector<hlsl::CodeLine> lines = hlsl::expanded_lines(preprocessed, main_file);
  const auto line = std::find_if(lines.begin(), lines.end(), [](const hlsl::CodeLine& code) {
    return code.text.find(printed_for_it) != std::string::npos;
  });
  if (line == lines.end()) return std::nullopt;
  const std::string text = sources.line(line->file, line->line);
  hlsl::Diagnostic diagnostic{line->file, line->line, 0, hlsl::Severity::error, {}, text};
  const std::size_t end = std::min(text.find("//"), text.size());
  for (std::size_t at = 0; at < end; ++at) {
    if (begins_a_token(text[at])) continue;
    diagnostic.column = static_cast<int>(at) + 1;
    diagnostic.message = in_words(text, at);
    return diagnostic;
  }
  diagnostic.message = "a character here, or in a macro used here, is not allowed in HLSL";
  return diagnostic;
}

}  // namespace penumbra::shaders
