#include "input/visible_text.h"

#include <gtest/gtest.h>

#include "input/input_error.h"

namespace penumbra {
namespace {

TEST(VisibleText, PlainTextStays) {
  EXPECT_EQ(visible("Wood \xC3\xA9t\xC3\xA9 \xE2\x80\xA6 \\ ~ \xF0\x9F\x8C\xB3"),
            "Wood \xC3\xA9t\xC3\xA9 \xE2\x80\xA6 \\ ~ \xF0\x9F\x8C\xB3");
  EXPECT_EQ(visible(""), "");
  EXPECT_EQ(visible("\xC2\xA0"), "\xC2\xA0") << "no-break space";
  EXPECT_EQ(visible("a::b #[c] # #[d"), "a::b #[c] # #[d");
}

TEST(VisibleText, BytesThatAreNoUtf8AreEscapes) {
  EXPECT_EQ(visible("\xFFx\x9B"
                    "31m\xE2\x80"),
            "\\xFFx\\x9B31m\\xE2\\x80");
  EXPECT_EQ(visible("\xC0\x80\xE0\x9F\xBF\xED\xA0\x80\xF4\x90\x80\x80"),
            "\\xC0\\x80\\xE0\\x9F\\xBF\\xED\\xA0\\x80\\xF4\\x90\\x80\\x80")
      << "overlong, surrogate, beyond the last character";
}

TEST(VisibleText, CommandsToGithubAreEscapes) {
  EXPECT_EQ(visible("::error ::x"), "\\x3A:error ::x");
  EXPECT_EQ(visible_line("  \t::error ::x"), "  \t\\x3A:error ::x") << "it trims lines";
  EXPECT_EQ(visible_lines("a\n ::b"), "a\n \\x3A:b");
  EXPECT_EQ(visible("x ##[error]y"), "x ##\\x5Berror]y");
}

TEST(VisibleText, ControlCharactersAreEscapes) {
  EXPECT_EQ(visible("a\n::error::b\r\t\x1B[2J\x1B]0;t\a\x7F"),
            "a\\n::error::b\\r\\t\\x1B[2J\\x1B]0;t\\x07\\x7F");
  EXPECT_EQ(visible(std::string_view("\0", 1)), "\\x00");
  EXPECT_EQ(visible("\xC2\x9B"
                    "31m\xC2\x80\xC2\x9F"),
            "\\x9B31m\\x80\\x9F")
      << "U+009B begins an escape sequence, too";
  EXPECT_EQ(visible_line("\tx\n"), "\tx\\n");
}

TEST(VisibleText, TheDirectionOfReadingDoesNotTurn) {
  EXPECT_EQ(visible("a\xE2\x80\xAE"
                    "b\xE2\x80\xAA\xE2\x81\xA6\xE2\x81\xA9"),
            "a\\u202Eb\\u202A\\u2066\\u2069");
  EXPECT_EQ(visible("\xD8\x9C\xE2\x80\x8E\xE2\x80\x8F\xE2\x80\xA8\xE2\x80\xA9"),
            "\\u061C\\u200E\\u200F\\u2028\\u2029");
  EXPECT_EQ(visible("\xE2\x80\x8D\xE2\x80\xAF\xE2\x81\xA5\xE2\x81\xAA"),
            "\xE2\x80\x8D\xE2\x80\xAF\xE2\x81\xA5\xE2\x81\xAA");
}

TEST(VisibleText, LongTextsLoseTheirMiddle) {
  const std::string longest(4000, 'x');
  EXPECT_EQ(visible(longest), longest);
  const std::string shown = visible("begin " + std::string(10'000'000, 'x') + " end");
  EXPECT_LT(shown.size(), 4100u);
  EXPECT_TRUE(shown.starts_with("begin x") && shown.ends_with("x end"));
  EXPECT_NE(shown.find("x ... (9996010 bytes left out) ... x"), std::string::npos);
  std::string accents;
  for (int i = 0; i < 3000; ++i) accents += i == 0 ? "x" : "\xC3\xA9";
  const std::string cut = visible(accents);
  EXPECT_EQ(cut[cut.find(" ... (") - 1], '\xA9') << "no character is cut in two";
  EXPECT_EQ(cut[cut.find(") ... ") + 6], '\xC3');
}

TEST(VisibleText, MessagesOfErrorsAreVisible) {
  EXPECT_STREQ(InputError("a\nb", "name '\x1B[1m'\n::error::x", "use 'c\x1B'\n  or d").what(),
               "a\\nb: name '\\x1B[1m'\\n::error::x\n  use 'c\\x1B'\n  or d");
}

}  // namespace
}  // namespace penumbra
