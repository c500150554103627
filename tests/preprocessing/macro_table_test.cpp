// Conditions of #if, with the macros known so far. The answers are C's (6.10.1), with 32 bits as in FXC.
#include "preprocessing/macro_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace penumbra::preprocessing {
namespace {

using testing::UnorderedElementsAre;

Condition ask(const std::string& text, const std::vector<std::string>& definitions = {}) {
  MacroTable macros;
  for (const std::string& definition : definitions) macros.define(definition);
  return macros.evaluate(text);
}

TEST(MacroTable, FollowsC) {
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

TEST(MacroTable, ReplacesMacros) {
  EXPECT_TRUE(ask("OUTER * 3 == 4", {"SUM 1 + 1", "OUTER SUM"}).holds) << "1 + 1 * 3, as text";
  EXPECT_FALSE(ask("A", {"A B", "B A"}).holds) << "no macro is replaced within itself";
  EXPECT_TRUE(ask("AT_LEAST(3) && !AT_LEAST(4)", {"V 3", "AT_LEAST(x) (V >= x)"}).holds);
  MacroTable macros;
  macros.define("A 1");
  macros.define("A 2");
  macros.define("1 A");
  EXPECT_TRUE(macros.is_defined("A"));
  EXPECT_TRUE(macros.evaluate("A == 2").holds);
  macros.undefine("A");
  macros.undefine("B");
  EXPECT_FALSE(macros.is_defined("A"));
  EXPECT_FALSE(macros.evaluate("A == 2").holds);
}

TEST(MacroTable, SaysWhatItConsulted) {
  EXPECT_THAT(ask("defined(A) && B > C", {"B D"}).consulted, UnorderedElementsAre("A", "B", "C", "D"));
}

// The messages are the preprocessor's.
TEST(MacroTable, SaysWhatItDoesNotUnderstand) {
  EXPECT_EQ(ask("1 +").problem, "this condition has no value");
  EXPECT_EQ(ask("09").problem, "in this condition: '09' is not an integer");
  EXPECT_EQ(ask("F(1, 2) > 0", {"F(x) x"}).problem, "too many arguments for macro 'F'");
  MacroTable macros;
  EXPECT_NE(macros.evaluate("(1").problem, "");
  EXPECT_TRUE(macros.evaluate("1").holds) << "an error has no effect on the next";
}

TEST(MacroTable, EndsHugeConditions) {
  std::string nested = "1";
  for (int i = 0; i < 40; ++i) nested = "D(" + nested + ")";
  EXPECT_EQ(ask(nested, {"D(x) x x x x x x x x"}).problem, "a macro expansion that is too large");
  std::vector<std::string> doublings{"M0 1"};
  for (int i = 1; i < 15; ++i)
    doublings.push_back("M" + std::to_string(i) + " M" + std::to_string(i - 1) + " + M" +
                        std::to_string(i - 1));
  MacroTable macros;
  for (const std::string& definition : doublings) macros.define(definition);
  int refused = 0;
  for (int i = 0; i < 400; ++i) refused += macros.evaluate("M14").problem.empty() ? 0 : 1;
  EXPECT_GT(refused, 0) << "the work of all conditions together is limited";
}

}  // namespace
}  // namespace penumbra::preprocessing
