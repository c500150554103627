#include "study/contact_sheet.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "study/picture_search.h"

namespace penumbra::study {
namespace {

Picture noise(int width, int height) {
  Picture picture = filled_picture(width, height, {});
  std::mt19937 random(9);
  for (std::uint8_t& sample : picture.samples) sample = static_cast<std::uint8_t>(random());
  return picture;
}

TEST(Insets, AreTheWindowsPixelsEnlargedAlike) {
  const Picture picture = noise(120, 60);
  const std::vector<PictureWindow> windows{{5, 7, 20, 12}, {60, 30, 16, 10}};
  const int factor = inset_factor(120, windows);
  EXPECT_EQ(factor, 2) << "120 less frames and a gap, by 36";
  const Picture sheet = with_insets(picture, 1, windows);
  EXPECT_EQ(sheet.width, 120);
  EXPECT_GT(sheet.height, 60 + 2 * 12);
  for (const PictureWindow& window : windows) {
    EXPECT_EQ(occurrences(sheet, enlarged(cropped(picture, window), factor)), 1);
    EXPECT_EQ(occurrences(sheet, cropped(picture, window)), 1) << "its place in the picture stays uncovered";
  }
}

TEST(Insets, EachHasTheColourOfItsPlace) {
  const Picture picture = filled_picture(120, 60, {200, 200, 200});
  const PictureWindow window{40, 20, 20, 12};
  const Picture sheet = with_insets(picture, 1, {window, {80, 20, 20, 12}});
  const Rgb mark = pixel(sheet, 39, 25);
  EXPECT_NE(mark, (Rgb{200, 200, 200}));
  EXPECT_EQ(pixel(sheet, 60, 25), mark);
  EXPECT_EQ(pixel(sheet, 50, 19), mark);
  EXPECT_EQ(pixel(sheet, 50, 32), mark);
  EXPECT_EQ(pixel(sheet, 40, 20), (Rgb{200, 200, 200}));
  EXPECT_EQ(pixel(sheet, 1, 80), mark) << "the first inset's frame";
  EXPECT_NE(pixel(sheet, 79, 25), mark) << "the second has another";
}

TEST(Insets, ZoomEnlargesThePictureAndLeavesInsetsWhatTheyAre) {
  const Picture picture = noise(40, 20);
  const Picture sheet = with_insets(picture, 3, {{4, 4, 10, 8}});
  EXPECT_EQ(sheet.width, 120);
  const int factor = inset_factor(120, {{4, 4, 10, 8}});
  EXPECT_EQ(factor, 11);
  EXPECT_EQ(occurrences(sheet, enlarged(cropped(picture, {4, 4, 10, 8}), factor)), 1);
  EXPECT_EQ(with_insets(picture, 2, {}), enlarged(picture, 2));
}

TEST(Insets, WhatDoesNotFitIsRefused) {
  const Picture picture = noise(40, 20);
  EXPECT_THROW(with_insets(picture, 1, {{30, 0, 11, 5}}), std::invalid_argument);
  EXPECT_THROW(with_insets(picture, 1, {{0, 0, 20, 5}, {0, 0, 20, 5}}), std::invalid_argument);
  EXPECT_EQ(inset_factor(40, {{0, 0, 20, 5}, {0, 0, 20, 5}}), 0);
}

}  // namespace
}  // namespace penumbra::study
