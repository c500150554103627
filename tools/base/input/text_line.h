// The rules for one line of text. They are the same for every language and format that is written, C#, HLSL,
// JSON and CSV among them, and for terminals. Texts of untrusted files become comments and titles there; a
// text that ended its line would continue as code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace penumbra {

// The character that begins at a place of a text.
struct TextCharacter {
  std::uint32_t code = 0;  // the byte, if it is not UTF-8
  std::size_t bytes = 1;
  bool is_valid = false;  // true for UTF-8
};
TextCharacter character_at(std::string_view text, std::size_t at);

// Returns whether it is UTF-8 and neither a control character (U+0000 to U+001F, U+007F to U+009F), some of
// which end lines, nor one that ends a line or paragraph (U+2028, U+2029) or turns the direction of text
// (U+061C, U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069).
bool stays_in_line(const TextCharacter& character);

bool is_one_line(std::string_view text);  // true if all characters stay in the line

std::string in_one_line(std::string_view text);  // replaces each character that does not stay by a space

}  // namespace penumbra
