// Character classes of identifiers, numbers and white space. Internal to this folder.
#pragma once

namespace penumbra::preparation {

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr bool is_identifier_character(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

}  // namespace penumbra::preparation
