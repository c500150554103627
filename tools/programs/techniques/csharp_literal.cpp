#include "techniques/csharp_literal.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>

#include "input/text_line.h"

namespace penumbra::techniques {

std::string csharp_float(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(value)).ptr;
  std::string digits(text.data(), end);
  if (digits.find_first_of(".e") == std::string::npos) digits += ".0";
  return digits + "f";
}

std::string csharp_text(const std::string& text) {
  std::string quoted = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const TextCharacter character = character_at(text, at);
    if (character.code == '"' || character.code == '\\') quoted += '\\';
    quoted += stays_in_line(character)
                  ? text.substr(at, character.bytes)
                  : fmt::format("\\u{:04X}", character.is_valid ? character.code : 0xFFFD);
    at += character.bytes;
  }
  return quoted + "\"";
}

std::string csharp_name(const std::string& name) {
  std::string text;
  bool begins = true;
  for (const unsigned char character : name) {
    const bool belongs = std::isalnum(character) != 0;
    if (belongs && text.empty() && std::isdigit(character) != 0) text = "Of";
    if (belongs) text += static_cast<char>(begins ? std::toupper(character) : character);
    begins = !belongs;
  }
  return text;
}

}  // namespace penumbra::techniques
