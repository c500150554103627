#include "validation/report_place.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace penumbra::validation {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

bool continues(char c) {
  return (static_cast<std::uint8_t>(c) & 0xC0U) == 0x80U;
}

// Returns the bytes of the well-formed sequence that starts the text (Unicode 15, table 3-7), or 0 where
// there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), continues)) return 0;
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool surrogate = lead == 0xED && byte(1) > 0x9F;
  const bool beyond = lead == 0xF4 && byte(1) > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

}  // namespace

std::string relative_file(const std::string& file, const ReportStyle& style) {
  const std::filesystem::path given = std::filesystem::path(file).lexically_normal();
  const std::filesystem::path path = (style.folder / given).lexically_normal();
  if (style.root.empty() || !path.is_absolute()) return given.generic_string();
  const std::filesystem::path relative = path.lexically_relative(style.root.lexically_normal());
  const bool below = !relative.empty() && *relative.begin() != "..";
  return (below ? relative : path).generic_string();
}

std::string uri_of(const std::string& file) {
  constexpr char digits[] = "0123456789ABCDEF";
  const std::string path = std::filesystem::path(file).generic_string();
  std::string uri =
      std::filesystem::path(file).is_absolute() ? path.front() == '/' ? "file://" : "file:///" : "";
  for (const char c : path) {
    const auto byte = static_cast<std::uint8_t>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 ||
                                       std::string_view("/-._~").find(c) != std::string_view::npos);
    if (plain) {
      uri += c;
    } else {
      uri.append(1, '%').append(1, digits[byte >> 4U]).append(1, digits[byte & 15U]);
    }
  }
  return uri;
}

int column_in_characters(std::string_view line, int column) {
  const std::size_t before = std::min(line.size(), static_cast<std::size_t>(std::max(column - 1, 0)));
  const auto end = line.begin() + static_cast<std::ptrdiff_t>(before);
  return column - static_cast<int>(std::count_if(line.begin(), end, continues));
}

std::string valid_utf8(std::string_view text) {
  std::string valid;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    valid += length == 0 ? replacement : text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return valid;
}

}  // namespace penumbra::validation
