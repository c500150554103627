#include "study/summary.h"

#include <gtest/gtest.h>

namespace penumbra::study {
namespace {

TEST(ShortTitle, LeavesOutAnAdaptersFile) {
  EXPECT_EQ(short_title("mine", "mine (Mine.hlsl)"), "mine");
}

TEST(ShortTitle, KeepsEveryOtherTitleWhole) {
  EXPECT_EQ(short_title("tent-3-plane", "Tent 3x3, receiver plane"), "Tent 3x3, receiver plane");
  EXPECT_EQ(short_title("pcss-poisson-25", "PCSS (Poisson) 25"), "PCSS (Poisson) 25");
  EXPECT_EQ(short_title("preset-high maxPenumbraMetres=2", "Penumbra High maxPenumbraMetres=2"),
            "Penumbra High maxPenumbraMetres=2");
  EXPECT_EQ(short_title("mine", "My own (new)"), "My own (new)");
  EXPECT_EQ(short_title("mine", ""), "mine");
}

}  // namespace
}  // namespace penumbra::study
