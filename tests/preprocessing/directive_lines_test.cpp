#include "preprocessing/directive_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace penumbra::preprocessing {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

TEST(DirectiveLines, KeepTheirPlaces) {
  const auto lines = directive_lines("float x;\n\n  #  pragma   vertex  Vert\n");
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_EQ(lines[0].name, "pragma");
  EXPECT_EQ(lines[0].line, 3);
  EXPECT_EQ(lines[0].column, 3);
  EXPECT_EQ(lines[0].rest, "vertex Vert");
  ASSERT_THAT(lines[0].words, SizeIs(2));
  EXPECT_EQ(lines[0].words[1].text, "Vert");
  EXPECT_EQ(lines[0].words[1].line, 3);
  EXPECT_EQ(lines[0].words[1].column, 23);
}

TEST(DirectiveLines, AreJoinedAtBackslashes) {
  const auto lines = directive_lines("#pragma multi_compile A \\\n    B\\\n C\n#if 1\n");
  ASSERT_THAT(lines, SizeIs(2));
  ASSERT_THAT(lines[0].words, SizeIs(4));
  EXPECT_EQ(lines[0].words[2].text, "B");
  EXPECT_EQ(lines[0].words[2].line, 2);
  EXPECT_EQ(lines[0].words[2].column, 5);
  EXPECT_EQ(lines[0].words[2].offset, 30U);
  EXPECT_EQ(lines[0].end.line, 3);
  EXPECT_EQ(lines[0].end.column, 3);
  EXPECT_FALSE(lines[0].line_comment);
  EXPECT_EQ(lines[1].line, 4);
}

TEST(DirectiveLines, CommentsAreBlanks) {
  const auto lines = directive_lines(
      "/* #pragma a */ #pragma b/**/c // d\n"
      "// #pragma e \\\n#pragma f\n"
      "/* one\n#pragma g\n*/#pragma h\n"
      "#pragma i /* to\n the end */ j\n");
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_EQ(lines[0].rest, "b c");
  EXPECT_TRUE(lines[0].line_comment);
  EXPECT_EQ(lines[1].rest, "h");
  EXPECT_EQ(lines[1].line, 6);
  EXPECT_EQ(lines[2].rest, "i j");
  EXPECT_EQ(lines[2].words[1].line, 8);
}

TEST(DirectiveLines, QuotesHideComments) {
  const auto lines = directive_lines("#include_with_pragmas \"a//b.hlsl\"\nfloat x; \"/*\n#pragma a\n");
  ASSERT_THAT(lines, SizeIs(2)) << "a text ends with its line";
  EXPECT_EQ(lines[0].rest, "\"a//b.hlsl\"");
  EXPECT_EQ(lines[1].rest, "a");
}

TEST(DirectiveLines, AHashWithinALineIsNone) {
  EXPECT_THAT(directive_lines("x = a #pragma b\n@#pragma\n"), IsEmpty());
  ASSERT_THAT(directive_lines("#"), SizeIs(1));
  EXPECT_EQ(directive_lines("#")[0].name, "");
  EXPECT_THAT(directive_lines(""), IsEmpty());
  EXPECT_THAT(directive_lines("/* never closed #pragma a"), IsEmpty());
}

}  // namespace
}  // namespace penumbra::preprocessing
