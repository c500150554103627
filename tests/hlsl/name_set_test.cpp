// A set holds its words and nothing that only looks like them.
#include "hlsl/name_set.h"

#include <gtest/gtest.h>

namespace penumbra::hlsl {
namespace {

TEST(NameSet, HoldsItsWordsAndNothingElse) {
  static constexpr NameSet set("in", "inout", "out", "nointerpolation", "_a1");
  for (const char* word : {"in", "inout", "out", "nointerpolation", "_a1"})
    EXPECT_TRUE(set.contains(word)) << word;
  for (const char* word : {"", "i", "io", "IN", "on", "inou", "inouts", "nointerpolatiom", "_a2", "?a1",
                           "a_word_that_is_longer_than_any_that_a_set_may_hold"})
    EXPECT_FALSE(set.contains(word)) << word;
}

}  // namespace
}  // namespace penumbra::hlsl
