// Edits move no token to another line.
#include "preparation/token_text.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "preparation/value_types.h"

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
  text.insert(5, "end");  // the word follows the last token
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
  EXPECT_EQ(text.matching_bracket(1), 6u);
  EXPECT_EQ(text.matching_bracket(5), 3u);
  EXPECT_EQ(text.matching_bracket(0), npos);
  text.insert(0, "{ }");
  text.apply();
  EXPECT_EQ(text.matching_bracket(0), 1u);
  EXPECT_EQ(text.matching_bracket(3), 8u);
  EXPECT_EQ(TokenText("( ]", "m").matching_bracket(0), npos);
}

// Requires of an edited text the same as of a text that never was another.
void expect_like_new(const TokenText& edited) {
  const std::string printed = edited.print();
  const TokenText fresh(printed, "m");
  ASSERT_EQ(edited.size(), fresh.size());
  for (std::size_t at = 0; at < fresh.size(); ++at) {
    EXPECT_EQ(edited.is_identifier(at), fresh.is_identifier(at)) << at;
    EXPECT_EQ(edited.lead(at), fresh[at].spelling[0]) << at;
    EXPECT_TRUE(edited.is(at, fresh[at].spelling)) << at;
    EXPECT_EQ(edited.matching_bracket(at), fresh.matching_bracket(at)) << at;
    EXPECT_EQ(edited.types().at(at).name, fresh.types().at(at).name) << at;
    EXPECT_EQ(edited.types().begin(at), fresh.types().begin(at)) << at;
  }
  ASSERT_EQ(edited.declarations().size(), fresh.declarations().size());
  for (std::size_t i = 0; i < fresh.declarations().size(); ++i) {
    EXPECT_EQ(edited.declarations()[i].kind, fresh.declarations()[i].kind) << i;
    EXPECT_EQ(edited.declarations()[i].first, fresh.declarations()[i].first) << i;
    EXPECT_EQ(edited.declarations()[i].last, fresh.declarations()[i].last) << i;
    EXPECT_EQ(edited.declarations()[i].name, fresh.declarations()[i].name) << i;
  }
}

TEST(TokenText, AfterEditsEverythingIsToldOfTheNewText) {
  TokenText text("float a; float f(float b) { return (a + b); } struct S { half c; }; S s;", "m");
  EXPECT_EQ(text.declarations().size(), 4u);
  EXPECT_EQ(text.types().structs().size(), 1u);
  EXPECT_EQ(text.free_name("d"), "d");
  EXPECT_EQ(text.free_name("a"), "a_");
  text.replace(0, 3, "int2 d[2]; ;");
  text.insert(text.size(), "void g() { s.c = d[0].x; }");
  text.apply();
  ASSERT_EQ(text.declarations().size(), 6u);
  EXPECT_EQ(text.free_name("d"), "d_");
  EXPECT_EQ(text.free_name("g"), "g_");
  EXPECT_EQ(text.types().at(1).name, "");
  expect_like_new(text);
  text.erase(0, 6);
  text.apply();
  EXPECT_EQ(text.free_name("int2"), "int2");
  expect_like_new(text);
}

TEST(TokenText, EditsThatChangeNothingKeepWhatIsKnown) {
  TokenText text("float a;", "m");
  const hlsl::Token* const first = text.tokens().data();
  text.insert(0, "");
  text.erase(1, 0);
  text.apply();
  EXPECT_EQ(text.tokens().data(), first);  // apply() writes its tokens elsewhere
}

// Words spelled alike, and no others, have the same number: in a text, and with what edits put in.
TEST(TokenText, WordNumbersAreThoseOfTheSpelling) {
  std::mt19937 random(5);
  const auto words = [&random](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
      text += random() % 2 == 0 ? "a_rather_long_name_" : "n";
      text += std::to_string(random() % 6000);
      text += random() % 4 == 0 ? " + 1.5 " : " ";
    }
    return text;
  };
  TokenText text(words(12000), "m");
  for (std::size_t at = 0; at < text.size(); at += 7) text.replace(at, random() % 3, words(3));
  text.apply();
  std::map<std::string_view, std::uint32_t> number_of;
  std::set<std::uint32_t> numbers;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::uint32_t number = text.identifier_number(at);
    EXPECT_EQ(number == hlsl::StringInterner::none, !text.is_identifier(at));
    if (!text.is_identifier(at)) continue;
    EXPECT_LT(number, text.identifier_count());
    EXPECT_EQ(number_of.emplace(text[at].spelling, number).first->second, number) << text[at].spelling;
    numbers.insert(number);
  }
  EXPECT_GT(number_of.size(), 5000u);
  EXPECT_EQ(numbers.size(), number_of.size());
}

// A random half of the tokens is taken out; the others stay where they were.
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
