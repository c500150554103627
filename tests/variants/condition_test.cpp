#include "variants/condition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace penumbra::variants {
namespace {

using testing::UnorderedElementsAre;

Condition ask(const std::string& text, const Macros& macros = {}) {
  std::size_t budget = 1'000'000;
  return evaluate(text, macros, budget);
}

TEST(Condition, FollowsC) {
  const std::pair<const char*, bool> answers[] = {
      {"1", true},
      {"0", false},
      {"!0", true},
      {"!1", false},
      {"1 && 0", false},
      {"1 || 0 && 0", true},
      {"(1 || 0) && 0", false},
      {"2 + 3 * 4 == 14", true},
      {"10 - 4 - 3 == 3", true},
      {"7 / 2 == 3 && 7 % 2 == 1", true},
      {"-7 / 2 == -3", true},
      {"1 << 4 == 16", true},
      {"(0x1F & ~3) == 28", true},
      {"017 == 15", true},
      {"5 > 4 > 3", false},
      {"1 == 1 == 1", true},
      {"1 ? 2 : 0", true},
      {"0 ? 1 : 0 ? 1 : 1", true},
      {"6 ^ 3 == 3", true},
      {"45u >= 35L", true},
      {"1 | 2 && 0", false},
      {"3 == 2 || 2 == 3", false},
      {"2 != 2", false},
      {"2 < 2 || 3 < 2", false},
      {"2 > 2 || 2 > 3", false},
      {"2 <= 2 && 1 <= 2", true},
      {"3 <= 2", false},
      {"2 >= 2 && 3 >= 2", true},
      {"2 >= 3", false},
      {"(6 & 3) == 2 && (6 | 3) == 7", true},
      {"40 >> 3 == 5", true},
      {"0 || 0", false},
      {"1 - 2 == -1", true},
      {"+3 == 3 && ~0 == -1", true},
  };
  for (const auto& [text, answer] : answers) {
    const Condition condition = ask(text);
    EXPECT_EQ(condition.holds, answer) << text;
    EXPECT_EQ(condition.problem, "") << text;
  }
}

TEST(Condition, AnUnknownNameIsNought) {
  EXPECT_FALSE(ask("FOO").holds);
  EXPECT_TRUE(ask("FOO == 0").holds);
  EXPECT_FALSE(ask("defined(FOO) || defined FOO").holds);
}

TEST(Condition, MacrosStandForTheirText) {
  const Macros macros{{"EMPTY", {"", false}},
                      {"TARGET", {"45", false}},
                      {"SUM", {"1 + 1", false}},
                      {"OUTER", {"SUM", false}}};
  EXPECT_TRUE(ask("TARGET >= 45 && defined(TARGET)", macros).holds);
  EXPECT_TRUE(ask("OUTER * 3 == 4", macros).holds) << "1 + 1 * 3, as text";
  EXPECT_TRUE(ask("defined EMPTY", macros).holds);
  EXPECT_EQ(ask("EMPTY", macros).problem, "the condition is empty");
}

TEST(Condition, AMacroIsNotReplacedWithinItself) {
  EXPECT_FALSE(ask("A", {{"A", {"A", false}}}).holds);
  EXPECT_FALSE(ask("A", {{"A", {"B", false}}, {"B", {"A", false}}}).holds);
  const Condition sum = ask("A == 1", {{"A", {"A + 1", false}}});
  EXPECT_TRUE(sum.holds);
  EXPECT_EQ(sum.problem, "");
}

TEST(Condition, SaysWhatItConsulted) {
  EXPECT_THAT(ask("defined(A) && B > C", {{"B", {"D", false}}}).consulted,
              UnorderedElementsAre("A", "B", "C", "D"));
}

TEST(Condition, SaysWhatItDoesNotUnderstand) {
  const std::pair<const char*, const char*> problems[] = {
      {"", "the condition is empty"},
      {"1 +", "a value is missing after '+'"},
      {"(1", "')' is missing"},
      {"1 2", "'2' is not expected here"},
      {")", "')' is not expected here"},
      {"defined", "'defined' must be followed by a name"},
      {"defined(A", "')' is missing after 'defined(A'"},
      {"1 / 0", "division by zero"},
      {"1 ? 2", "':' is missing after '?'"},
      {"1.5 > 1", "'.' is not expected here"},
      {"09", "'09' is not an integer"},
  };
  for (const auto& [text, problem] : problems) EXPECT_EQ(ask(text).problem, problem) << text;
}

TEST(Condition, MacrosWithParametersAreReplaced) {
  const Macros macros{{"V", {" 3", false}},
                      {"AT_LEAST", {"(x) (V >= x)", true}},
                      {"BETWEEN", {"(a, b) (AT_LEAST(a) && V <= (b))", true}},
                      {"NOTHING", {"() 1", true}},
                      {"AGAIN", {"(x) AGAIN(x) + x", true}}};
  EXPECT_TRUE(ask("AT_LEAST(3)", macros).holds);
  EXPECT_FALSE(ask("AT_LEAST(4)", macros).holds);
  EXPECT_NE(ask("BETWEEN(2, (4, 5))", macros).problem, "") << "',' is no operator";
  EXPECT_TRUE(ask("BETWEEN(AT_LEAST(3), 4)", macros).holds) << "1 to 4";
  EXPECT_TRUE(ask("NOTHING() && NOTHING( )", macros).holds);
  EXPECT_FALSE(ask("AT_LEAST", macros).holds) << "without parentheses no use of it";
  EXPECT_TRUE(ask("AGAIN(1)", macros).problem.find("'('") != std::string::npos)
      << "its own name is not replaced";
  EXPECT_EQ(ask("defined(AT_LEAST) && AT_LEAST(1)", macros).consulted,
            (std::set<std::string>{"AT_LEAST", "V"}));
}

TEST(Condition, SaysWhichMacrosWithParametersItDoesNotReplace) {
  EXPECT_EQ(ask("F(1, 2) > 0", {{"F", {"(x) x", true}}}).problem, "'F' takes 1 argument and has 2");
  EXPECT_EQ(ask("F(1", {{"F", {"(x) x", true}}}).problem, "'F' has no ')' after its arguments");
  EXPECT_EQ(ask("F(1)", {{"F", {"(x) x ## 2", true}}}).problem, "'F' uses # or ## in its replacement list");
}

TEST(Condition, ArgumentsDoNotGrowWithoutBound) {
  Macros macros{{"D", {"(x) x x x x x x x x", true}}};
  std::string nested = "1";
  for (int i = 0; i < 40; ++i) nested = "D(" + nested + ")";
  EXPECT_EQ(ask(nested, macros).problem, "the condition is too long once its macros are replaced");
}

TEST(Condition, WhatIsNotNeededIsNotDivided) {
  EXPECT_EQ(ask("0 && 1 / 0").problem, "");
  EXPECT_EQ(ask("1 || 1 % 0").problem, "");
  EXPECT_EQ(ask("1 ? 1 : 1 / 0").problem, "");
  EXPECT_EQ(ask("0 || 1 / 0").problem, "division by zero");
}

TEST(Condition, ArithmeticWraps) {
  EXPECT_TRUE(ask("9223372036854775807 + 1 < 0").holds);
  EXPECT_EQ(ask("(-9223372036854775807 - 1) / -1 < 0").problem, "");
  EXPECT_TRUE(ask("(1 << 64) == 0 && (-1 >> 70) == -1").holds);
}

TEST(Condition, NestingAndGrowthAreBounded) {
  EXPECT_EQ(ask(std::string(100000, '(')).problem, "the condition is too long once its macros are replaced");
  EXPECT_EQ(ask(std::string(3000, '(')).problem, "the condition is nested too deeply");
  EXPECT_EQ(ask(std::string(3000, '!') + "1").problem, "the condition is nested too deeply");
  Macros doubling{{"M0", {"1", false}}};
  for (int i = 1; i <= 40; ++i) {
    const std::string inner = "M" + std::to_string(i - 1);
    doubling["M" + std::to_string(i)] = {inner + "+" + inner, false};
  }
  EXPECT_EQ(ask("M40", doubling).problem, "the condition is too long once its macros are replaced");
  Macros chain{{"C0", {"1", false}}};
  for (int i = 1; i <= 500; ++i) chain["C" + std::to_string(i)] = {"C" + std::to_string(i - 1), false};
  EXPECT_EQ(ask("C500", chain).problem, "macros are nested more than 64 deep");
  EXPECT_TRUE(ask("C60", chain).holds);
}

TEST(Condition, OneBudgetServesAllConditions) {
  std::size_t budget = 10;
  EXPECT_TRUE(evaluate("1 == 1", {}, budget).holds);
  EXPECT_EQ(budget, 7U);
  EXPECT_EQ(evaluate("1 + 1 + 1 + 1 + 1", {}, budget).problem,
            "the condition is too long once its macros are replaced");
}

}  // namespace
}  // namespace penumbra::variants
