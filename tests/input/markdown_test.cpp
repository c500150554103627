#include "input/markdown.h"

#include <gmock/gmock.h>

#include "input/input_error_matcher.h"

namespace penumbra {
namespace {

using testing::HasSubstr;

TEST(Markdown, ACellCannotBreakItsTable) {
  EXPECT_EQ(markdown_cell("a|b<c>&\nd"), "a\\|b&lt;c>&amp; d");
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
