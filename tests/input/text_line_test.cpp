// Every character of Unicode is compared with an independent list of those that do not stay in a line.
#include "input/text_line.h"

#include <gtest/gtest.h>

#include <set>

namespace penumbra {
namespace {

std::string utf8(std::uint32_t code) {
  const auto tail = [](std::uint32_t bits) { return static_cast<char>(0x80U | (bits & 0x3FU)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0U | code >> 6U), tail(code)};
  if (code < 0x10000) return {static_cast<char>(0xE0U | code >> 12U), tail(code >> 6U), tail(code)};
  return {static_cast<char>(0xF0U | code >> 18U), tail(code >> 12U), tail(code >> 6U), tail(code)};
}

// The characters of the categories Cc, Zl and Zp, and those with the property Bidi_Control (Unicode 15).
std::set<std::uint32_t> leaving() {
  std::set<std::uint32_t> codes{0x2028, 0x2029, 0x061C, 0x200E, 0x200F};
  for (std::uint32_t code = 0; code < 0x20; ++code) codes.insert(code);
  for (std::uint32_t code = 0x7F; code <= 0x9F; ++code) codes.insert(code);
  for (std::uint32_t code = 0x202A; code <= 0x202E; ++code) codes.insert(code);
  for (std::uint32_t code = 0x2066; code <= 0x2069; ++code) codes.insert(code);
  return codes;
}

TEST(TextLine, EveryCharacterOfUnicodeStaysOrIsListed) {
  const std::set<std::uint32_t> leave = leaving();
  for (std::uint32_t code = 0; code <= 0x10FFFF; ++code) {
    if (code == 0xD800) code = 0xE000;  // halves of pairs are no characters
    const std::string text = "a" + utf8(code) + "b";
    const TextCharacter read = character_at(text, 1);
    ASSERT_TRUE(read.is_valid && read.code == code && read.bytes == text.size() - 2) << std::hex << code;
    const bool leaves = leave.contains(code);
    ASSERT_EQ(is_one_line(text), !leaves) << std::hex << code;
    ASSERT_EQ(in_one_line(text), leaves ? "a b" : text) << std::hex << code;
  }
}

TEST(TextLine, BytesThatAreNoCharacterLeave) {
  for (const std::string text :
       {"\xFF", "\x80", "\xC0\x80", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x80", "\xC3"}) {
    EXPECT_FALSE(is_one_line(text));
    EXPECT_EQ(in_one_line("a" + text + "b"), "a" + std::string(text.size(), ' ') + "b");
  }
}

}  // namespace
}  // namespace penumbra
