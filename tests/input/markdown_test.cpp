#include "input/markdown.h"

#include <gmock/gmock.h>

#include "input/input_error_matcher.h"

namespace penumbra {
namespace {

using testing::HasSubstr;

TEST(Markdown, ACellCannotBreakItsTable) {
  EXPECT_EQ(markdown_cell("a|b<c>&\nd"), "a\\|b&lt;c>&amp; d");
}

TEST(Markdown, ACellIsTextAlone) {
  EXPECT_EQ(markdown_cell("[a](b) *c* `d` \\"), "\\[a\\](b) \\*c\\* \\`d\\` \\\\");
  EXPECT_EQ(markdown_cell("a\x1B[2J\a\t\x7F"
                          "b\u00B0"),
            "a \\[2J   b\u00B0");
  EXPECT_EQ(markdown_cell("--> <!-- x:end -->"), "--> &lt;!-- x:end -->");
  EXPECT_EQ(markdown_cell("a\u2028b\u0085c\u202Ed"), "a b c d");
  EXPECT_EQ(markdown_cell("_a_ b_c +_D ~~d~~"), "_a\\_ b_c +_D \\~\\~d\\~\\~");
  EXPECT_EQ(markdown_cell("@everyone https://a.example a: b"), "&#64;everyone https&#58;//a.example a: b");
}

TEST(Markdown, CodeEndsWhereItsTextDoes) {
  EXPECT_EQ(markdown_code("tent-5"), "`tent-5`");
  EXPECT_EQ(markdown_code("a`b``c|d"), "```a`b``c\\|d```");
  EXPECT_EQ(markdown_code("`a"), "`` `a ``");
  EXPECT_EQ(markdown_code("--> <!-- x:end -->\n"), "`--> <! -- x:end --> `");
  EXPECT_EQ(markdown_code("a\u2028b\u202Ec"), "`a b c`");
  EXPECT_EQ(markdown_code_block("sh", "ls | wc"), "```sh\nls | wc\n```\n");
  EXPECT_EQ(markdown_code_block("sh", "a\n```\n<!-- x:end -->"), "````sh\na ``` <! -- x:end -->\n````\n");
}

TEST(Markdown, ATableHasNumbersAtTheRight) {
  EXPECT_EQ(markdown_table({"a", "b", "c"}, {{"1", "2", "3"}}),
            "| a | b | c |\n|:--|--:|--:|\n| 1 | 2 | 3 |\n");
  EXPECT_EQ(markdown_table({"a", "b", "c"}, {}, 1), "| a | b | c |\n|:--|--:|:--|\n");
}

TEST(Markdown, ABlockIsReplacedAndTheRestKept) {
  const std::string text =
      "# Title\r\n<!-- one:begin -->old<!-- one:end -->\n<!-- two:begin --><!-- two:end -->";
  EXPECT_EQ(replace_block(text, "one", "new\n", "x.md"),
            "# Title\r\n<!-- one:begin -->\nnew\n<!-- one:end -->\n<!-- two:begin --><!-- two:end -->");
}

TEST(Markdown, MarkersStandOnceAndInOrder) {
  const auto replace = [](const char* text) { return [text] { replace_block(text, "one", "new", "x.md"); }; };
  expect_input_error(replace("<!-- two:begin -->"),
                     HasSubstr("x.md: the marker '<!-- one:begin -->' is missing"));
  expect_input_error(replace("<!-- one:begin -->"), HasSubstr("'<!-- one:end -->' is missing"));
  expect_input_error(replace("<!-- one:begin --><!-- one:begin --><!-- one:end -->"),
                     HasSubstr("appears twice"));
  expect_input_error(replace("<!-- one:end --><!-- one:begin -->"), HasSubstr("before the begin marker"));
}

}  // namespace
}  // namespace penumbra
