#include "input/text_line.h"

namespace penumbra {
namespace {

unsigned char byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

// Returns 0 for a byte that begins no character.
std::size_t character_bytes(std::string_view text, std::size_t at) {
  const unsigned char first = byte_at(text, at);
  if (first < 0x80) return 1;
  const std::size_t count = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  if (at + count > text.size()) return 0;
  for (std::size_t i = 1; i < count; ++i)
    if ((byte_at(text, at + i) & 0xC0U) != 0x80) return 0;
  const unsigned char second = byte_at(text, at + 1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool beyond = (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
  return overlong || beyond ? 0 : count;
}

}  // namespace

TextCharacter character_at(std::string_view text, std::size_t at) {
  const std::size_t bytes = character_bytes(text, at);
  const std::uint32_t first = byte_at(text, at);
  if (bytes == 0) return {first, 1, false};
  std::uint32_t code = bytes == 1 ? first : first & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) code = code << 6U | (byte_at(text, at + i) & 0x3FU);
  return {code, bytes, true};
}

bool stays_in_line(const TextCharacter& character) {
  const auto within = [&](std::uint32_t first, std::uint32_t last) {
    return character.code >= first && character.code <= last;
  };
  const bool is_control = within(0, 0x1F) || within(0x7F, 0x9F);
  const bool ends_line = within(0x2028, 0x2029);
  const bool turns_direction =
      within(0x061C, 0x061C) || within(0x200E, 0x200F) || within(0x202A, 0x202E) || within(0x2066, 0x2069);
  return character.is_valid && !is_control && !ends_line && !turns_direction;
}

bool is_one_line(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const TextCharacter character = character_at(text, at);
    if (!stays_in_line(character)) return false;
    at += character.bytes;
  }
  return true;
}

std::string in_one_line(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const TextCharacter character = character_at(text, at);
    if (stays_in_line(character))
      line += text.substr(at, character.bytes);
    else
      line += ' ';
    at += character.bytes;
  }
  return line;
}

}  // namespace penumbra
