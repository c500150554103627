#include "input/visible_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "input/text_line.h"

namespace penumbra {
namespace {

constexpr char kDigits[] = "0123456789ABCDEF";
constexpr std::size_t kShownAtBegin = 3000;
constexpr std::size_t kShownAtEnd = 1000;

std::string hex_escape(unsigned char byte) {
  return {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
}

std::string unicode_escape(std::uint32_t character) {
  std::string text = "\\u";
  for (int shift = 12; shift >= 0; shift -= 4)
    text += kDigits[character >> static_cast<unsigned>(shift) & 15U];
  return text;
}

// GitHub Actions take "::" at the beginning of a line and "##[" anywhere for commands.
bool begins_command(std::string_view text, std::size_t at) {
  if (text[at] == '[') return at >= 2 && text[at - 1] == '#' && text[at - 2] == '#';
  return text.substr(at, 2) == "::" && text.substr(0, at).find_first_not_of(" \t") == std::string_view::npos;
}

std::string escape(const TextCharacter& character) {
  if (character.code > 0xFF) return unicode_escape(character.code);
  if (character.code == '\n') return "\\n";
  if (character.code == '\r') return "\\r";
  return character.code == '\t' ? "\\t" : hex_escape(static_cast<unsigned char>(character.code));
}

std::string escaped(std::string_view text, bool keep_tabs) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const TextCharacter character = character_at(text, i);
    const bool stays = stays_in_line(character) || (keep_tabs && character.code == '\t');
    if (stays && !begins_command(text, i))
      out += text.substr(i, character.bytes);
    else
      out += escape(character);
    i += character.bytes;
  }
  return out;
}

// Both functions cut between the characters of UTF-8.
bool is_inside_character(std::string_view text, std::size_t at) {
  return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80;
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
