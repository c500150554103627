#include "hlsl/token_place.h"

#include <gtest/gtest.h>

#include <string>

namespace penumbra::hlsl {
namespace {

TEST(ColumnIn, CountsTheSameSpellingFromTheLeft) {
  EXPECT_EQ(column_in("a = b + b;", "b", 0, 2), 5);
  EXPECT_EQ(column_in("a = b + b;", "b", 1, 2), 9);
  EXPECT_EQ(column_in("ab = b;", "b", 0, 1), 6) << "not inside another word";
  EXPECT_EQ(column_in("a == b = c;", "=", 0, 1), 8) << "not inside another operator";
}

TEST(ColumnIn, SkipsComments) {
  EXPECT_EQ(column_in("a /* b */ = b; // b", "b", 0, 1), 13);
  EXPECT_EQ(column_in("a = b; /* b", "b", 0, 1), 5);
}

TEST(ColumnIn, SaysNothingWhenMacrosBroughtSome) {
  EXPECT_EQ(column_in("a = TWICE(b);", "b", 0, 2), 0);
}

TEST(ColumnAfterCode, EndsBeforeCommentsAndBlanks) {
  EXPECT_EQ(column_after_code("  return x   // half"), 11);
  EXPECT_EQ(column_after_code("  return x /* half */  "), 11);
  EXPECT_EQ(column_after_code("// all"), 1);
}

class PlacesOfExpandedText : public testing::Test {
 protected:
  PlacesOfExpandedText() {
    sources.add("a.hlsl", "#define TWICE(x) ((x) + (x))\nfloat F(float v) {\n  return TWICE(v) >= v;\n}\n");
  }

  std::size_t nth(const std::string& spelling, std::size_t rank) const {
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i].spelling == spelling && rank-- == 0) return i;
    return places.size();
  }

  SourceFiles sources;
  const std::string expanded = "\nfloat F ( float v ) {\n  return ( ( v ) + ( v ) ) >= v ;\n}\n";
  TokenPlaces places{expanded, "a.hlsl"};
};

TEST_F(PlacesOfExpandedText, KeepsOperatorsWhole) {
  const std::string text = places.one_per_line();
  EXPECT_NE(text.find("\n>=\n"), std::string::npos) << text;
  EXPECT_EQ(text.substr(0, 8), "float\nF\n");
}

TEST_F(PlacesOfExpandedText, ATokenOfAMacroStandsAtItsCall) {
  const TokenPlace plus = places.at(nth("+", 0), sources);
  EXPECT_EQ(plus.file, "a.hlsl");
  EXPECT_EQ(plus.line, 3);
  EXPECT_EQ(plus.column, 10);
}

TEST_F(PlacesOfExpandedText, ATokenOfItsOwnStandsWhereItIsWritten) {
  EXPECT_EQ(places.at(nth(">=", 0), sources).column, 19);
  EXPECT_EQ(places.after(nth(">=", 0), sources).column, 21);
  EXPECT_EQ(places.after(nth(";", 0), sources).column, 24) << "the last of its line";
}

TEST_F(PlacesOfExpandedText, FindsDefinitionsBeforeDeclarations) {
  const std::string text = "float G ( ) ;\nfloat H ( ) { return G ( ) ; }\nfloat G ( ) { return 1 ; }\n";
  const TokenPlaces functions(text, "a.hlsl");
  EXPECT_EQ(functions[functions.function("G")].line, 3);
  EXPECT_EQ(functions[functions.function("H")].line, 2);
  EXPECT_EQ(functions.function("K"), functions.size());
}

}  // namespace
}  // namespace penumbra::hlsl
