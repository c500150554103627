#include "hlsl/diagnostic.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace penumbra::hlsl {
namespace {

TEST(Diagnostic, PutsTheCaretUnderTheColumn) {
  const Diagnostic diagnostic{"a.hlsl", 3, 5, Severity::error, "no such thing", "abc def"};
  EXPECT_EQ(format(diagnostic), "a.hlsl:3:5: error: no such thing\n    abc def\n        ^");
}

TEST(Diagnostic, CountsCharactersBeforeTheCaret) {
  const std::string line = "/* \xC3\xA4\xE2\x82\xAC */ x;";  // an a with two dots, a euro sign
  EXPECT_EQ(format({"a.hlsl", 1, 13, Severity::error, "bad", line}),
            "a.hlsl:1:13: error: bad\n    " + line + "\n             ^");
}

TEST(Diagnostic, KeepsTabsBeforeTheCaret) {
  const Diagnostic diagnostic{"a.hlsl", 1, 3, Severity::warning, "hm", "\t\tx"};
  EXPECT_EQ(format(diagnostic), "a.hlsl:1:3: warning: hm\n    \t\tx\n    \t\t^");
}

TEST(Diagnostic, LeavesOutWhatIsUnknown) {
  EXPECT_EQ(format({"a.hlsl", 0, 0, Severity::error, "m", {}}), "a.hlsl: error: m");
  EXPECT_EQ(format({"a.hlsl", 7, 0, Severity::note, "m", "text"}), "a.hlsl:7: note: m\n    text");
  EXPECT_EQ(format({"", 0, 0, Severity::error, "m", {}}), "error: m");
}

TEST(Diagnostic, ACaretPastTheEndOfTheLineStaysInPlace) {
  EXPECT_EQ(format({"a", 1, 4, Severity::error, "m", "x"}), "a:1:4: error: m\n    x\n       ^");
}

TEST(Diagnostic, AnyColumnIsHarmless) {
  const int far = std::numeric_limits<int>::max();
  EXPECT_EQ(format({"a", 1, far, Severity::error, "m", "x"}),
            "a:1:2147483647: error: m\n    x\n    " + std::string(161, ' ') + "^");
  EXPECT_EQ(format({"a", 1, -5, Severity::error, "m", "x"}), "a:1: error: m\n    x");
}

TEST(Diagnostic, OfALongLineTheSurroundingsOfTheColumnAreShown) {
  const std::string line = std::string(1'000'000, 'a') + "here" + std::string(1'000'000, 'b');
  EXPECT_EQ(format({"a", 1, 1'000'001, Severity::error, "m", line}),
            "a:1:1000001: error: m\n    ..." + std::string(80, 'a') + "here" + std::string(76, 'b') +
                "...\n    " + std::string(83, ' ') + "^");
  EXPECT_EQ(format({"a", 1, 2, Severity::error, "m", line}),
            "a:1:2: error: m\n    " + std::string(160, 'a') + "...\n     ^");
}

TEST(Diagnostic, ControlCharactersAreShownAsEscapes) {
  EXPECT_EQ(format({"a\n::error::b", 1, 3, Severity::error, "no '\x1B[2J'", "\x1B]x"}),
            "a\\n::error::b:1:3: error: no '\\x1B[2J'\n    \\x1B]x\n         ^");
}

TEST(Diagnostic, OnlyErrorsAreErrors) {
  EXPECT_FALSE(has_errors({{"a", 1, 1, Severity::warning, "m", {}}, {"a", 1, 1, Severity::note, "m", {}}}));
  EXPECT_TRUE(has_errors({{"a", 1, 1, Severity::warning, "m", {}}, {"a", 1, 1, Severity::error, "m", {}}}));
}

}  // namespace
}  // namespace penumbra::hlsl
