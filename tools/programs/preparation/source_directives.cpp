#include "preparation/source_directives.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "hlsl/identifier.h"

namespace penumbra::preparation {

namespace {

// Returns the specifier of a warning that begins with these two letters; empty if there is none.
std::string_view specifier_of(std::string_view letters) {
  for (const std::string_view specifier : {"disable", "enable", "default", "error", "once"})
    if (specifier.starts_with(letters)) return specifier;
  return {};
}

// Returns the pragma that a line with one of the identifiers stands for.
std::optional<std::string> pragma_of(std::string_view line) {
  while (!line.empty() && (hlsl::is_blank(line.back()) || line.back() == ';')) line.remove_suffix(1);
  while (!line.empty() && hlsl::is_blank(line.front())) line.remove_prefix(1);
  if (line == kPackedByRows) return "#pragma pack_matrix(row_major)";
  if (line == kPackedByColumns) return "#pragma pack_matrix(column_major)";
  if (!line.starts_with(kWarningPragma)) return std::nullopt;
  line.remove_prefix(kWarningPragma.size());
  std::string pragma("#pragma warning(");
  pragma.append(specifier_of(line.substr(0, 2))).append(" :");
  for (const char c : line.substr(std::min<std::size_t>(2, line.size()))) pragma += c == '_' ? ' ' : c;
  return pragma + ")";
}

// Returns the digits that replace those of an integer with a suffix, where FXC keeps the low 32 bits of up to
// 64; empty for other numbers. They are hexadecimal, because no notation has fewer.
std::string low_bits(std::string_view number) {
  const std::size_t digits = number.find_last_not_of("uUlL") + 1;
  const bool hexadecimal = number.size() > 1 && (number[1] == 'x' || number[1] == 'X');
  const char* const end = number.data() + digits;
  std::uint64_t value = 0;
  const auto read = std::from_chars(number.data() + (hexadecimal ? 2 : 0), end, value,
                                    hexadecimal        ? 16
                                    : number[0] == '0' ? 8
                                                       : 10);
  if (digits == number.size() || read.ec != std::errc() || read.ptr != end || value >> 32U == 0) return {};
  std::string low(digits, '0');
  low[1] = 'x';
  for (std::size_t place = digits; place > digits - 8; value >>= 4U)
    low[--place] = "0123456789abcdef"[value & 15U];
  return low;
}

class SourceScan {
 public:
  explicit SourceScan(std::string text) : text_(std::move(text)) {}

  std::string run() {
    while (at_ < text_.size()) step();
    return std::move(text_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool starts(std::string_view with) const { return text_.compare(at_, with.size(), with) == 0; }

  void step() {
    const char c = peek();
    if (c == '\n') {
      line_is_empty_ = true;
      ++at_;
    } else if (hlsl::is_blank(c)) {
      ++at_;
    } else if (starts("//")) {
      at_ = end_of_line();
    } else if (starts("/*")) {
      at_ = std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2;
    } else if (c == '#' && line_is_empty_) {
      directive();
    } else {
      line_is_empty_ = false;
      token(c);
    }
  }

  void token(char c) {
    if (c == '"') {
      text();
    } else if (c == '\'') {
      character();
    } else if (hlsl::is_digit(c) || (c == '.' && hlsl::is_digit(peek(1)))) {
      number();
    } else if (hlsl::continues_identifier(c)) {
      while (hlsl::continues_identifier(peek())) ++at_;
    } else {
      ++at_;
    }
  }

  void text() {
    for (++at_; at_ < text_.size() && peek() != '"' && peek() != '\n'; ++at_)
      if (peek() == '\\' && peek(1) != '\n') ++at_;
    if (peek() == '"') ++at_;
  }

  // The literal 'N' becomes 78, padded with spaces: a literal has at least three characters, and a value
  // below 256.
  void character() {
    const std::size_t begin = at_++;
    const bool escape = peek() == '\\';
    if (peek() == '\0' || peek() == '\n') return;
    const int value = escape ? escaped() : static_cast<unsigned char>(text_[at_++]);
    if (peek() != '\'' || value < 0 || (!escape && at_ != begin + 2)) {
      at_ = begin + 1;  // an apostrophe
      return;
    }
    std::string number = std::to_string(value);
    number.resize(std::max(number.size(), ++at_ - begin), ' ');
    text_.replace(begin, at_ - begin, number);
  }

  // Returns the value of an escape sequence after a backslash; -1 if it does not fit a byte.
  int escaped() {
    constexpr std::string_view letters = "abfnrtv";
    constexpr std::string_view meant = "\a\b\f\n\r\t\v";
    const char c = peek(1);
    at_ += 2;
    if (const std::size_t letter = letters.find(c); letter != std::string_view::npos) return meant[letter];
    const bool hexadecimal = c == 'x';
    if (!hexadecimal && (c < '0' || c > '7')) return c == '\n' || c == '\0' ? -1 : c;
    if (!hexadecimal) --at_;
    int value = 0;
    const auto read =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value, hexadecimal ? 16 : 8);
    at_ = static_cast<std::size_t>(read.ptr - text_.data());
    return read.ec == std::errc() && value < 256 ? value : -1;
  }

  // Rewrites the suffix h of 1.0h, 1.#INF, and integers of more than 32 bits.
  void number() {
    const std::size_t begin = at_;
    const bool hexadecimal = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
    for (++at_; at_ < text_.size(); ++at_) {
      const char before = text_[at_ - 1];
      const bool sign = (peek() == '+' || peek() == '-') && (before == 'e' || before == 'E') && !hexadecimal;
      if (!hlsl::continues_identifier(peek()) && peek() != '.' && !sign) break;
    }
    const std::string_view spelling = std::string_view(text_).substr(begin, at_ - begin);
    if (spelling == "1." && starts("#INF")) {
      text_.replace(begin, 6, "1e9999");
      at_ = begin + 6;
    } else if (!hexadecimal && (spelling.back() == 'h' || spelling.back() == 'H')) {
      const bool whole = spelling.find_first_not_of("0123456789hH") == std::string_view::npos;
      text_[at_ - 1] = whole ? '.' : 'f';  // 1h is the number 1., and 1f is none
    } else if (const std::string low = low_bits(spelling); !low.empty()) {
      text_.replace(begin, low.size(), low);
    }
  }

  // Returns the end of the line, including the lines that '\' joins to it.
  std::size_t end_of_line() const {
    std::size_t end = at_;
    while (end < text_.size() && (text_[end] != '\n' || text_[end - 1] == '\\')) ++end;
    return end;
  }

  // A /* */ that begins on the directive's line may end on a later one: the directive ends before it.
  std::size_t end_of_directive() const {
    const std::size_t end = end_of_line();
    return std::min(end, text_.find("/*", at_));
  }

  void directive() {
    std::size_t word = at_ + 1;
    while (word < text_.size() && hlsl::is_blank(text_[word])) ++word;
    std::size_t word_end = word;
    while (word_end < text_.size() && hlsl::continues_identifier(text_[word_end])) ++word_end;
    const std::string_view name = std::string_view(text_).substr(word, word_end - word);
    line_is_empty_ = false;
    if (name == "include" || name == "include_with_pragmas" || name == "error") {
      at_ = end_of_line();  // no literals within strings
    } else if (name == "pragma") {
      const std::size_t end = end_of_directive();
      const std::string_view rest = std::string_view(text_).substr(word_end, end - word_end);
      const std::string marker = packing_marker(rest) + warning_marker(rest);
      const std::size_t begin = std::exchange(at_, end);
      if (marker.empty() || marker.size() > end - begin) return;
      for (std::size_t i = begin; i < end; ++i)
        if (text_[i] != '\n') text_[i] = ' ';
      text_.replace(begin, marker.size(), marker);
    } else {
      at_ = word_end;
    }
  }

  // Returns the replacement of `#pragma warning(disable : 3206)`; empty for other pragmas, and for one with
  // several specifiers.
  static std::string warning_marker(std::string_view pragma) {
    if (first_word(pragma) != "warning") return {};
    const std::string_view list = pragma.substr(0, pragma.find("//")).substr(pragma.find("warning") + 7);
    std::string marker;
    std::string word;
    for (const char c : std::string(list) + ' ') {
      if (hlsl::continues_identifier(c)) {
        word += c;
        continue;
      }
      if (c == ';') return {};
      if (marker.empty() && word.size() > 1 && specifier_of(word.substr(0, 2)) == word)
        marker.append(kWarningPragma).append(word, 0, 2);
      else if (!word.empty() && !marker.empty() && word.find_first_not_of("0123456789") == std::string::npos)
        marker.append("_").append(word);
      else if (!word.empty())
        return {};
      word.clear();
    }
    return marker.empty() ? marker : marker + ";";
  }

  // Returns the replacement of `#pragma pack_matrix(row_major)` until matrix_layout.cpp reads it; it is
  // shorter than the directive.
  static std::string packing_marker(std::string_view pragma) {
    if (first_word(pragma) != "pack_matrix") return {};
    std::string order;
    pragma = pragma.substr(0, pragma.find("//"));
    for (const char c : pragma.substr(pragma.find("pack_matrix") + 11))
      if (!hlsl::is_blank(c) && c != '\r')
        order += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    if (order == "(row_major)") return std::string(kPackedByRows) + ";";
    return std::string(order == "(column_major)" ? kPackedByColumns : kPackedOtherwise) + ";";
  }

  static std::string_view first_word(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    std::size_t end = begin;
    while (end < text.size() && hlsl::continues_identifier(text[end])) ++end;
    return text.substr(begin, end - begin);
  }

  std::string text_;
  std::size_t at_ = 0;
  bool line_is_empty_ = true;
};

}  // namespace

std::string prepare_source(std::string text) {
  return SourceScan(std::move(text)).run();
}

std::string with_pragmas(const std::string& expanded) {
  std::string text;
  for (std::size_t begin = 0; begin <= expanded.size();) {
    const std::size_t end = std::min(expanded.find('\n', begin), expanded.size());
    const std::string_view line = std::string_view(expanded).substr(begin, end - begin);
    text += pragma_of(line).value_or(std::string(line));
    if (end < expanded.size()) text += '\n';
    begin = end + 1;
  }
  return text;
}

}  // namespace penumbra::preparation
