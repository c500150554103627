#include "study/html_text.h"

#include <gtest/gtest.h>

#include <vector>

namespace penumbra::study {
namespace {

std::vector<std::byte> bytes(std::string_view text) {
  std::vector<std::byte> result;
  for (const char c : text) result.push_back(static_cast<std::byte>(c));
  return result;
}

TEST(EscapeHtml, NothingOfMeaningToHtmlIsLeft) {
  EXPECT_EQ(escape_html("<script>\"&'</script>"), "&lt;script&gt;&quot;&amp;&#39;&lt;/script&gt;");
  EXPECT_EQ(escape_html("tent 5×5, 2°\ttab\nline"), "tent 5×5, 2°\ttab\nline");
}

TEST(EscapeHtml, WhatIsNoTextBecomesTheReplacementCharacter) {
  const std::string mark = "\xEF\xBF\xBD";
  EXPECT_EQ(escape_html(std::string("a\0b\x1B\x7F", 5)), "a" + mark + "b" + mark + mark);
  EXPECT_EQ(escape_html("\xFF<"), mark + "&lt;");
  EXPECT_EQ(escape_html("\xC3<"), mark + "&lt;") << "a cut sequence must not swallow the next letter";
  EXPECT_EQ(escape_html("\xE2\x82"), mark + mark);
  EXPECT_EQ(escape_html("\xC0\xBC"), mark + mark) << "an overlong '<'";
  EXPECT_EQ(escape_html("\xED\xA0\x80"), mark + mark + mark) << "a surrogate";
  EXPECT_EQ(escape_html("\xF4\x90\x80\x80"), mark + mark + mark + mark) << "beyond U+10FFFF";
}

TEST(CommandHtml, WordsStayWholeAndAreEscaped) {
  EXPECT_EQ(
      command_html("a --b <c>"),
      "<pre class=\"command\"><code><span>a</span> <span>--b</span> <span>&lt;c&gt;</span></code></pre>\n");
  EXPECT_EQ(command_html(" a  b"),
            "<pre class=\"command\"><code> <span>a</span>  <span>b</span></code></pre>\n");
}

TEST(Base64, IsThatOfRfc4648) {
  // The examples are those of section 10 of the RFC.
  EXPECT_EQ(base64(bytes("")), "");
  EXPECT_EQ(base64(bytes("f")), "Zg==");
  EXPECT_EQ(base64(bytes("fo")), "Zm8=");
  EXPECT_EQ(base64(bytes("foo")), "Zm9v");
  EXPECT_EQ(base64(bytes("foob")), "Zm9vYg==");
  EXPECT_EQ(base64(bytes("fooba")), "Zm9vYmE=");
  EXPECT_EQ(base64(bytes("foobar")), "Zm9vYmFy");
  EXPECT_EQ(base64(bytes("\xFB\xFF\xBF")), "+/+/");
}

}  // namespace
}  // namespace penumbra::study
