#include "input/visible_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace penumbra {
namespace {

constexpr char kDigits[] = "0123456789ABCDEF";
constexpr std::size_t kShownAtBegin = 3000;
constexpr std::size_t kShownAtEnd = 1000;

unsigned char byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

std::string hex_escape(unsigned char byte) {
  return {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
}

// Of the character that begins here: its bytes; 1 for a byte that begins none.
std::size_t character_bytes(std::string_view text, std::size_t at) {
  const unsigned char first = byte_at(text, at);
  const std::size_t count = first < 0xC2 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 1;
  if (at + count > text.size()) return 1;
  for (std::size_t i = 1; i < count; ++i)
    if ((byte_at(text, at + i) & 0xC0U) != 0x80) return 1;
  const unsigned char second = byte_at(text, at + 1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool beyond = (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
  return overlong || beyond ? 1 : count;
}

std::uint32_t character_at(std::string_view text, std::size_t at, std::size_t bytes) {
  std::uint32_t character = byte_at(text, at) & (bytes == 2 ? 0x1FU : bytes == 3 ? 0x0FU : 0x07U);
  for (std::size_t i = 1; i < bytes; ++i) character = character << 6U | (byte_at(text, at + i) & 0x3FU);
  return character;
}

// Ends a line, or has to do with the direction in which text is read.
bool moves_text(std::uint32_t character) {
  return (character >= 0x202A && character <= 0x202E) || (character >= 0x2066 && character <= 0x2069) ||
         character == 0x200E || character == 0x200F || character == 0x061C || character == 0x2028 ||
         character == 0x2029;
}

std::string unicode_escape(std::uint32_t character) {
  std::string text = "\\u";
  for (int shift = 12; shift >= 0; shift -= 4)
    text += kDigits[character >> static_cast<unsigned>(shift) & 15U];
  return text;
}

// "::" at the begin of a line and "##[" anywhere are commands to GitHub Actions.
bool begins_command(std::string_view text, std::size_t at) {
  if (text[at] == '[') return at >= 2 && text[at - 1] == '#' && text[at - 2] == '#';
  return text[at] == ':' && byte_at(text, at + 1) == ':' &&
         text.substr(0, at).find_first_not_of(" \t") == std::string_view::npos;
}

std::string escaped(std::string_view text, bool keep_tabs) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const unsigned char byte = byte_at(text, i);
    const std::size_t bytes = character_bytes(text, i);
    if (byte == '\n' || byte == '\r' || (byte == '\t' && !keep_tabs)) {
      out += byte == '\n' ? "\\n" : byte == '\r' ? "\\r" : "\\t";
    } else if ((byte < 0x20 && byte != '\t') || byte == 0x7F || (byte >= 0x80 && bytes == 1) ||
               begins_command(text, i)) {
      out += hex_escape(byte);
    } else if (const std::uint32_t character = character_at(text, i, bytes);
               bytes > 1 && moves_text(character)) {
      out += unicode_escape(character);
    } else if (bytes == 2 && character < 0xA0) {
      out += hex_escape(static_cast<unsigned char>(character));
    } else {
      out += text.substr(i, bytes);
    }
    i += bytes;
  }
  return out;
}

// Both cut between the characters of UTF-8.
bool is_inside_character(std::string_view text, std::size_t at) {
  return (byte_at(text, at) & 0xC0U) == 0x80;
}

std::string_view characters_before(std::string_view text, std::size_t end) {
  while (end > 0 && is_inside_character(text, end)) --end;
  return text.substr(0, end);
}

std::string_view characters_behind(std::string_view text, std::size_t begin) {
  while (begin < text.size() && is_inside_character(text, begin)) ++begin;
  return text.substr(begin);
}

}  // namespace

std::string visible(std::string_view text) {
  const std::size_t shown = kShownAtBegin + kShownAtEnd;
  if (text.size() <= shown) return escaped(text, false);
  return escaped(characters_before(text, kShownAtBegin), false) + " ... (" +
         std::to_string(text.size() - shown) + " bytes left out) ... " +
         escaped(characters_behind(text, text.size() - kShownAtEnd), false);
}

std::string visible_line(std::string_view text) {
  return escaped(text, true);
}

std::string visible_lines(std::string_view text) {
  std::string out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    out += (begin > 0 ? "\n" : "") + visible(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

}  // namespace penumbra
