#include "input/visible_text.h"

#include <algorithm>
#include <cstddef>

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

// Of U+202A to U+202E and U+2066 to U+2069 the last byte; 0 for all others.
unsigned char turns_direction(std::string_view text, std::size_t at) {
  if (byte_at(text, at) != 0xE2) return 0;
  const unsigned char second = byte_at(text, at + 1);
  const unsigned char third = byte_at(text, at + 2);
  const bool embeds = second == 0x80 && third >= 0xAA && third <= 0xAE;
  const bool isolates = second == 0x81 && third >= 0xA6 && third <= 0xA9;
  return embeds || isolates ? third : 0;
}

std::string escaped(std::string_view text, bool keep_tabs) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned char byte = byte_at(text, i);
    if (byte == '\n' || byte == '\r' || (byte == '\t' && !keep_tabs)) {
      out += byte == '\n' ? "\\n" : byte == '\r' ? "\\r" : "\\t";
    } else if ((byte < 0x20 && byte != '\t') || byte == 0x7F) {
      out += hex_escape(byte);
    } else if (byte == 0xC2 && byte_at(text, i + 1) >= 0x80 && byte_at(text, i + 1) < 0xA0) {
      out += hex_escape(byte_at(text, ++i));
    } else if (const unsigned char last = turns_direction(text, i); last != 0) {
      out += std::string(last >= 0xAA ? "\\u202" : "\\u206") + kDigits[last & 15U];
      i += 2;
    } else {
      out += static_cast<char>(byte);
    }
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
