#include "project/package_version.h"

#include <algorithm>
#include <charconv>

namespace penumbra::project {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_identifier_character(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '.';
}

// Takes a number of at most nine digits off the front.
std::optional<std::uint32_t> take_number(std::string_view& text) {
  std::size_t digits = 0;
  while (digits < text.size() && is_digit(text[digits])) ++digits;
  if (digits == 0 || digits > 9) return std::nullopt;
  std::uint32_t number = 0;
  std::from_chars(text.data(), text.data() + digits, number);
  text.remove_prefix(digits);
  return number;
}

bool take(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

std::string_view take_identifier(std::string_view& text) {
  const std::string_view identifier = text.substr(0, text.find('.'));
  text.remove_prefix(std::min(text.size(), identifier.size() + 1));
  return identifier;
}

std::string_view without_leading_zeros(std::string_view number) {
  while (number.size() > 1 && number.front() == '0') number.remove_prefix(1);
  return number;
}

std::strong_ordering compare_identifiers(std::string_view a, std::string_view b) {
  const bool a_is_number = !a.empty() && std::all_of(a.begin(), a.end(), is_digit);
  const bool b_is_number = !b.empty() && std::all_of(b.begin(), b.end(), is_digit);
  if (a_is_number != b_is_number)
    return a_is_number ? std::strong_ordering::less : std::strong_ordering::greater;
  if (!a_is_number) return a <=> b;
  a = without_leading_zeros(a);
  b = without_leading_zeros(b);
  return a.size() != b.size() ? a.size() <=> b.size() : a <=> b;
}

std::strong_ordering compare_prereleases(std::string_view a, std::string_view b) {
  // A release is newer than its pre-releases.
  if (a.empty() || b.empty()) return a.empty() <=> b.empty();
  while (!a.empty() && !b.empty()) {
    const std::strong_ordering order = compare_identifiers(take_identifier(a), take_identifier(b));
    if (order != std::strong_ordering::equal) return order;
  }
  return b.empty() <=> a.empty();  // the one with more identifiers is newer
}

}  // namespace

std::optional<PackageVersion> parse_package_version(std::string_view text) {
  const auto major = take_number(text);
  if (!major || !take(text, '.')) return std::nullopt;
  const auto minor = take_number(text);
  if (!minor || !take(text, '.')) return std::nullopt;
  const auto patch = take_number(text);
  if (!patch) return std::nullopt;
  PackageVersion version{*major, *minor, *patch};
  const std::string_view rest = text.substr(0, text.find('+'));
  if (rest.empty()) return version;
  if (rest.front() != '-' || rest.size() == 1) return std::nullopt;
  if (!std::all_of(rest.begin(), rest.end(), is_identifier_character)) return std::nullopt;
  version.prerelease = rest.substr(1);
  return version;
}

std::strong_ordering operator<=>(const PackageVersion& a, const PackageVersion& b) {
  if (a.major != b.major) return a.major <=> b.major;
  if (a.minor != b.minor) return a.minor <=> b.minor;
  if (a.patch != b.patch) return a.patch <=> b.patch;
  return compare_prereleases(a.prerelease, b.prerelease);
}

bool operator==(const PackageVersion& a, const PackageVersion& b) {
  return (a <=> b) == std::strong_ordering::equal;
}

}  // namespace penumbra::project
