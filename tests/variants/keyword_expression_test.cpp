#include "variants/narrowing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "input/input_error_matcher.h"
#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<std::string> narrowed(const std::string& text, const std::string& expression) {
  return texts_of(
      KeywordSpace(pragmas_of(text), {parse_keyword_expression(expression), {}, {}, {}}).whole_program());
}

TEST(KeywordExpression, PinsExcludesAndChooses) {
  const std::string text = "#pragma multi_compile _ A\n#pragma multi_compile _ B C D\n";
  EXPECT_THAT(narrowed(text, ""), SizeIs(8));
  EXPECT_THAT(narrowed(text, "+A"), ElementsAre("A", "A B", "A C", "A D"));
  EXPECT_THAT(narrowed(text, "-A,-B"), ElementsAre("-", "C", "D"));
  EXPECT_THAT(narrowed(text, " -A  C|D "), ElementsAre("C", "D"));
  EXPECT_THAT(narrowed(text, "-A C|_"), ElementsAre("-", "C"));
  EXPECT_THAT(narrowed(text, "+A +A +C"), ElementsAre("A C"));
}

TEST(KeywordExpression, SaysWhatIsWrong) {
  const std::string remedy = "\n  write +NAME (always on), -NAME (never on) or A|B (only these of their set)";
  const std::pair<const char*, const char*> cases[] = {
      {"A", "--keywords: 'A' does not say whether it is on or off"},
      {"+", "--keywords: '+' does not name a keyword"},
      {"-_", "--keywords: '-_' does not name a keyword"},
      {"+A-B", "--keywords: '+A-B' does not name a keyword"},
      {"+A -A", "--keywords: '-A' contradicts '+A'"},
      {"A|", "--keywords: 'A|' lacks a name next to '|'"},
      {"_|__", "--keywords: '_|__' names no keyword, so it is not known which sets it is for"},
      {"A|2", "--keywords: 'A|2' holds '2', which is not a keyword"},
  };
  for (const auto& [expression, message] : cases) {
    expect_input_error([&, text = expression] { parse_keyword_expression(text); }, message + remedy);
  }
}

TEST(KeywordExpression, MisspeltKeywordsAreFound) {
  const Pragmas pragmas = pragmas_of("#pragma multi_compile _ _NORMALMAP\n#pragma dynamic_branch FADE\n");
  EXPECT_THAT(
      unknown_keywords(parse_keyword_expression("-_NORMAL_MAP +_NORMALMAP -FADE QQQQQQQQQ|_"), {&pragmas}),
      ElementsAre("--keywords -_NORMAL_MAP: no program declares '_NORMAL_MAP'; did you mean '_NORMALMAP'?",
                  "--keywords QQQQQQQQQ|_: no program declares 'QQQQQQQQQ'"));
  EXPECT_THAT(unknown_keywords({}, {&pragmas}), IsEmpty());
}

}  // namespace
}  // namespace penumbra::variants
