// Edits move no token to another line.
#include "preparation/token_text.h"

#include <gtest/gtest.h>

#include <random>

namespace penumbra::preparation {
namespace {

struct Placed {
  std::string spelling, file;
  int line;
  bool operator==(const Placed&) const = default;
};

std::vector<Placed> placed(const std::string& text) {
  std::vector<Placed> tokens;
  for (const hlsl::Token& token : hlsl::lex(text))
    tokens.push_back({std::string(token.spelling), std::string(token.file), token.line});
  return tokens;
}

const char* const kText =
    "#line 3 \"a.hlsl\"\nfloat f(float x)\n{ return x+=1; }\n#line 90 \"b b.hlsl\"\n\n\nint i;\n"
    "#line 7\nint j; \"text\" 1.5e-3\n";

TEST(TokenText, PrintsEveryTokenOnItsLine) {
  const TokenText text(kText, "main.hlsl");
  EXPECT_EQ(placed(text.print()), placed(kText));
}

TEST(TokenText, LinesBeforeTheFirstDirectiveAreTheMainFiles) {
  EXPECT_EQ(placed(TokenText("\n\na", "main.hlsl").print()), (std::vector<Placed>{{"a", "main.hlsl", 3}}));
}

TEST(TokenText, MarksThatStandTogetherStayTogetherAndOthersApart) {
  const std::string printed = TokenText("a+ +b ++c a<=b a< =b", "m").print();
  EXPECT_NE(printed.find("a+ +b ++c a<=b a< =b"), std::string::npos) << printed;
}

TEST(TokenText, AnEditStandsOnTheLineOfWhatItReplaces) {
  TokenText text("a b\nc d\ne", "m");
  text.replace(2, 2, "x +\n y");
  text.insert(2, "before");
  text.insert(5, "end");  // follows the last token
  text.erase(0, 1);
  text.apply();
  EXPECT_EQ(placed(text.print()), (std::vector<Placed>{{"b", "m", 1},
                                                       {"before", "m", 1},
                                                       {"x", "m", 2},
                                                       {"+", "m", 2},
                                                       {"y", "m", 2},
                                                       {"e", "m", 3},
                                                       {"end", "m", 3}}));
}

TEST(TokenText, PartnersAreFoundAfterEdits) {
  TokenText text("f ( a [ 1 ] ) { }", "m");
  EXPECT_EQ(text.partner(1), 6u);
  EXPECT_EQ(text.partner(5), 3u);
  EXPECT_EQ(text.partner(0), npos);
  text.insert(0, "{ }");
  text.apply();
  EXPECT_EQ(text.partner(0), 1u);
  EXPECT_EQ(text.partner(3), 8u);
  EXPECT_EQ(TokenText("( ]", "m").partner(0), npos);
}

// Taking out a random half of the tokens leaves the others where they were.
TEST(TokenText, RandomErasuresMoveNothing) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    std::string source;
    for (int i = 0; i < 40; ++i)
      source += random() % 4 == 0 ? "\n" : random() % 9 == 0 ? "\n#line 55 \"f\"\n" : "word ";
    TokenText text(source, "m");
    std::vector<Placed> expected;
    for (std::size_t at = 0; at < text.size(); ++at) {
      if (random() % 2 == 0) {
        text.erase(at, 1);
      } else {
        expected.push_back({std::string(text[at].spelling), text.file_of(at), text[at].line});
      }
    }
    text.apply();
    EXPECT_EQ(placed(text.print()), expected);
  }
}

}  // namespace
}  // namespace penumbra::preparation
