#include "study/lettering.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "study/picture_search.h"

namespace penumbra::study {
namespace {

constexpr Rgb kInk{0, 0, 0};

Picture written(const Lettering& letters, const std::string& text) {
  Picture picture = filled_picture(letters.width(text) + 4, letters.line_height(), {255, 255, 255});
  letters.draw(picture, 2, 0, text, kInk);
  return picture;
}

TEST(Lettering, TheSameTextIsTheSamePixelsAndAnotherIsAnother) {
  const Lettering letters(20);
  EXPECT_EQ(written(letters, "Penumbra"), written(letters, "Penumbra"));
  EXPECT_NE(written(letters, "Penumbra"), written(letters, "Penumbrn"));
  EXPECT_EQ(letters.line_height(), 20);
}

TEST(Lettering, ALargerSizeIsAsMuchWider) {
  const std::string text = "ray traced, light of 2\u00B0";
  EXPECT_NEAR(Lettering(40).width(text), 2 * Lettering(20).width(text), 2);
}

TEST(Lettering, ADegreeSignIsOneCharacterAndNoQuestionMark) {
  const Lettering letters(20);
  EXPECT_NE(written(letters, "\u00B0"), written(letters, "?"));
  EXPECT_LT(letters.width("\u00B0"), 12);
}

TEST(Lettering, WhatIsNoTextIsDrawnAsQuestionMarks) {
  const Lettering letters(20);
  for (const std::string broken : {"\xC3", "\xFF", "\x80", "\n", "\U0010FFFF"}) {
    EXPECT_EQ(written(letters, broken), written(letters, "?"))
        << static_cast<int>(static_cast<unsigned char>(broken[0]));
  }
  EXPECT_EQ(letters.width("\xE2\x82"), letters.width("??")) << "cut short";
}

TEST(Lettering, CutsWholeCharacters) {
  const Lettering letters(20);
  const std::string text = "5\u00B0\u00B0\u00B0";
  const int two = letters.width("5\u00B0");
  EXPECT_EQ(letters.cut_to(text, two + 1), "5\u00B0");
  EXPECT_EQ(letters.cut_to(text, 1000), text);
  EXPECT_EQ(letters.cut_to(text, 0), "");
}

TEST(Lettering, BeyondThePictureNothingIsDrawn) {
  const Lettering letters(20);
  Picture small = filled_picture(6, 6, {255, 255, 255});
  letters.draw(small, -30, -5, "Penumbra", kInk);
  letters.draw(small, 100, 100, "Penumbra", kInk);
  EXPECT_EQ(small.samples.size(), 108U);
}

}  // namespace
}  // namespace penumbra::study
