#include "techniques/emitted_text.h"

#include <array>
#include <cctype>
#include <charconv>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "input/text_line.h"

namespace penumbra::techniques {

std::string csharp_float(double value) {
  std::string digits = table_number(value);
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

std::string xml_text(const std::string& text) {
  std::string safe;
  for (const char character : text)
    safe += character == '<' ? "&lt;" : character == '&' ? "&amp;" : std::string(1, character);
  return safe;
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

std::string csharp_list(const std::vector<std::string>& items, std::size_t indent, std::size_t begun) {
  constexpr std::size_t kColumns = 116;  // 120, with what closes the list
  std::string text;
  std::size_t column = indent + begun;
  for (const std::string& item : items) {
    const bool fits = column + item.size() + 2 <= kColumns;
    if (!text.empty()) text += fits ? ", " : ",\n" + std::string(indent, ' ');
    if (!fits) column = indent;
    text += item;
    column += item.size() + 2;
  }
  return text;
}

std::string comment_lines(const std::string& text, std::string_view first, std::string_view next) {
  constexpr std::size_t kColumns = 120;
  std::string lines, line(first);
  std::istringstream words(text);
  bool has_word = false;
  for (std::string word; words >> word; has_word = true) {
    if (has_word && line.size() + 1 + word.size() > kColumns)
      lines += std::exchange(line, std::string(next)) + "\n";
    line += (line.ends_with(' ') ? "" : " ") + word;
  }
  return lines + line + "\n";
}

std::string table_number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(value)).ptr;
  return {text.data(), end};
}

TableRow::TableRow(const std::string& kind) : text_(kind) {}

TableRow& TableRow::add(std::string_view column) {
  if (!is_one_line(column)) throw std::invalid_argument("a column of a table is one line without tabs");
  text_.append("\t").append(column);
  return *this;
}

TableRow& TableRow::option(const std::string& name, const std::string& value) {
  return value.empty() ? *this : add(name + "=" + value);
}

TableRow& TableRow::option(const std::string& name, int value, int otherwise) {
  return value == otherwise ? *this : add(name + "=" + std::to_string(value));
}

TableRow& TableRow::option(const std::string& name, bool is_set) {
  return is_set ? add(name) : *this;
}

}  // namespace penumbra::techniques
