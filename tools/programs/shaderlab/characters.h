// Character classes of ShaderLab; its keywords are case-insensitive. Internal to this folder.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace penumbra::shaderlab {

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Bytes above ASCII count as letters: they are parts of UTF-8 characters.
inline bool is_word_start(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

inline bool is_identifier_character(char c) {
  return is_word_start(c) || is_digit(c);
}

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

inline char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

inline std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) { return upper(c); });
  return result;
}

inline bool same_keyword(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return upper(x) == upper(y); });
}

inline std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return is_blank(c) || c == '\n'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace penumbra::shaderlab
