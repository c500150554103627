#include "hlsl/expanded_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <tuple>
#include <vector>

#include "hlsl/tokens.h"

namespace penumbra::hlsl {
namespace {

using Place = std::tuple<std::string, std::string, int, std::size_t>;

// The spelling, file, line and column of every token.
std::vector<Place> places(const std::string& text) {
  std::vector<Place> all;
  for (const Token& token : lex(text)) {
    const auto offset = static_cast<std::size_t>(token.spelling.data() - text.data());
    const std::size_t newline = offset == 0 ? std::string::npos : text.rfind('\n', offset - 1);
    all.emplace_back(token.spelling, token.file, token.line,
                     offset - (newline == std::string::npos ? 0 : newline + 1));
  }
  return all;
}

TEST(DenseLines, WhatWasLeftOutMakesNoDifference) {
  const std::string one = "#line 1 \"a.hlsl\"\n#line 1 \"b.hlsl\"\n\n\n#line 7 \"a.hlsl\"\n  float x;\n";
  const std::string other = "#line 5 \"a.hlsl\"\n\n   \n  float x;\n\n\n";
  EXPECT_EQ(dense_lines(one), "#line 7 \"a.hlsl\"\n  float x;\n");
  EXPECT_EQ(dense_lines(other), dense_lines(one));
}

TEST(DenseLines, FewEmptyLinesStayAndManyBecomeADirective) {
  EXPECT_EQ(dense_lines("a\n\n\nb\n"), "a\n\n\nb\n");
  EXPECT_EQ(dense_lines("a\n" + std::string(40, '\n') + "b"), "a\n#line 42\nb\n");
  EXPECT_EQ(dense_lines("\n\n"), "");
}

TEST(DenseLines, AFileWithoutANameFollowsOneWithAName) {
  const std::string text = "#line 4 \"a\"\nl\n#line 2 \"\"\nl\n";
  EXPECT_EQ(dense_lines(text), text);
  EXPECT_EQ(places(dense_lines(text)), places(text));
}

TEST(DenseLines, OtherDirectivesAreCode) {
  EXPECT_EQ(dense_lines("#pragma pack_matrix(row_major)\n#line x\nfloat a;"),
            "#pragma pack_matrix(row_major)\n#line x\nfloat a;\n");
}

TEST(DenseLines, CodeKeepsItsPlaces) {
  std::mt19937 random(3);
  const std::vector<std::string> lines{"",
                                       "",
                                       "  ",
                                       "float4 a;",
                                       "   b = \"#line 3\";",
                                       "#line 5",
                                       "#line 900 \"x.hlsl\"",
                                       "#line 2 \"y.hlsl\"",
                                       "#pragma p",
                                       "}",
                                       "\t"};
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (std::size_t n = random() % 30; n > 0; --n) text += lines[random() % lines.size()] + "\n";
    const std::string dense = dense_lines(text);
    ASSERT_EQ(places(dense), places(text)) << text;
    ASSERT_EQ(dense_lines(dense), dense) << text;
  }
}

}  // namespace
}  // namespace penumbra::hlsl
