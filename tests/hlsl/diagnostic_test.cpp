#include "hlsl/diagnostic.h"

#include <gtest/gtest.h>

namespace penumbra::hlsl {
namespace {

TEST(Diagnostic, PutsTheCaretUnderTheColumn) {
  const Diagnostic diagnostic{"a.hlsl", 3, 5, Severity::error, "no such thing", "abc def"};
  EXPECT_EQ(format(diagnostic), "a.hlsl:3:5: error: no such thing\n    abc def\n        ^");
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

TEST(Diagnostic, OnlyErrorsAreErrors) {
  EXPECT_FALSE(has_errors({{"a", 1, 1, Severity::warning, "m", {}}, {"a", 1, 1, Severity::note, "m", {}}}));
  EXPECT_TRUE(has_errors({{"a", 1, 1, Severity::warning, "m", {}}, {"a", 1, 1, Severity::error, "m", {}}}));
}

}  // namespace
}  // namespace penumbra::hlsl
