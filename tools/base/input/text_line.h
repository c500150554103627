// What one line of text is: the same for every language and format that is written, C#, HLSL, JSON, Markdown
// and CSV among them, and for terminals. Texts of untrusted files become comments and titles there; one that
// ended its line would go on as code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace penumbra {

// The character that begins at a place of a text.
struct TextCharacter {
  std::uint32_t code = 0;  // of a byte that is not UTF-8, the byte
  std::size_t bytes = 1;
  bool is_valid = false;  // UTF-8
};
TextCharacter character_at(std::string_view text, std::size_t at);

// Whether it is UTF-8 and neither a control character (U+0000 to U+001F, U+007F to U+009F), of which some end
// lines, nor one that ends a line or paragraph (U+2028, U+2029) or turns the direction of text (U+061C,
// U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069).
bool stays_in_line(const TextCharacter& character);

bool is_one_line(std::string_view text);  // whether all characters stay in it

std::string in_one_line(std::string_view text);  // with a space for each that does not

}  // namespace penumbra
