#include "study/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "input/input_error.h"
#include "study/colour_map.h"
#include "study/composition.h"
#include "study/picture_search.h"

namespace penumbra::study {
namespace {

Picture noise(int width, int height, int channels) {
  Picture picture{width, height, channels, {}};
  std::mt19937 random(3);
  picture.samples.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                         static_cast<std::size_t>(channels));
  for (std::uint8_t& sample : picture.samples) sample = static_cast<std::uint8_t>(random());
  return picture;
}

TEST(Png, EverySampleComesBack) {
  for (const int channels : {1, 3, 4}) {
    const Picture picture = noise(37, 11, channels);
    EXPECT_EQ(decode_png(encode_png(picture), "test"), picture) << channels << " channels";
  }
}

TEST(Png, TheSamePictureIsTheSameBytes) {
  EXPECT_EQ(encode_png(noise(20, 20, 3)), encode_png(noise(20, 20, 3)));
}

// The picture has greys and one colour, as a sheet of visibility has: a palette of 256 holds them, 257 would
// be too many.
TEST(Png, FewColoursTakeAPalette) {
  Picture picture = filled_picture(257, 8, {7, 8, 9});
  for (int x = 1; x < 256; ++x) {
    const auto grey = static_cast<std::uint8_t>(x);
    set_pixel(picture, x, 0, {grey, grey, grey});
  }
  const std::vector<std::byte> small = encode_png(picture);
  EXPECT_EQ(decode_png(small, "test"), picture);
  Picture more = picture;
  set_pixel(more, 256, 0, {1, 2, 3});
  const std::vector<std::byte> large = encode_png(more);
  EXPECT_EQ(decode_png(large, "test"), more);
  constexpr std::size_t kColourType = 25;  // offset of the IHDR chunk's colour type
  EXPECT_EQ(static_cast<int>(small[kColourType]), 3) << "palette";
  EXPECT_EQ(static_cast<int>(large[kColourType]), 2) << "RGB";
}

TEST(Crop, KeepsTheWindowsPixels) {
  const Picture picture = noise(12, 9, 3);
  const Picture part = cropped(picture, {3, 2, 5, 4});
  ASSERT_EQ(part.width, 5);
  ASSERT_EQ(part.height, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) EXPECT_EQ(pixel(part, x, y), pixel(picture, 3 + x, 2 + y)) << x << ", " << y;
  }
  EXPECT_EQ(cropped(picture, {0, 0, 12, 9}), picture);
}

TEST(Crop, BeyondThePictureIsRefused) {
  const Picture picture = noise(12, 9, 3);
  const std::vector<PictureWindow> beyond{{-1, 0, 4, 4}, {0, -1, 4, 4}, {9, 0, 4, 4},
                                          {0, 6, 4, 4},  {0, 0, 0, 4},  {0, 0, 4, 0}};
  for (const PictureWindow& window : beyond) {
    EXPECT_THROW(cropped(picture, window), std::invalid_argument) << window.x << ", " << window.y;
  }
}

TEST(Zoom, EveryPixelIsASquare) {
  const Picture picture = noise(5, 4, 3);
  const Picture large = enlarged(picture, 3);
  ASSERT_EQ(large.width, 15);
  ASSERT_EQ(large.height, 12);
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 15; ++x)
      EXPECT_EQ(pixel(large, x, y), pixel(picture, x / 3, y / 3)) << x << ", " << y;
  }
}

TEST(Shrink, EverySquareBecomesItsMean) {
  const Picture picture = noise(6, 4, 3);
  const Picture small = shrunk(picture, 2);
  ASSERT_EQ(small.width, 3);
  ASSERT_EQ(small.height, 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      const int sum = pixel(picture, 2 * x, 2 * y).g + pixel(picture, 2 * x + 1, 2 * y).g +
                      pixel(picture, 2 * x, 2 * y + 1).g + pixel(picture, 2 * x + 1, 2 * y + 1).g;
      EXPECT_EQ(int{pixel(small, x, y).g}, (sum + 2) / 4) << x << ", " << y;
    }
  }
  EXPECT_EQ(shrunk(enlarged(picture, 3), 3), picture);
  EXPECT_THROW(shrunk(picture, 4), std::invalid_argument);
}

TEST(Narrow, EveryPixelIsTheMeanOfItsArea) {
  const Picture picture = noise(6, 4, 3);
  EXPECT_EQ(narrowed(picture, 6), picture);
  EXPECT_EQ(narrowed(picture, 7), picture);
  EXPECT_EQ(narrowed(picture, 3), shrunk(picture, 2));
  EXPECT_EQ(narrowed(enlarged(picture, 3), 6), picture);
  EXPECT_EQ(narrowed(enlarged(picture, 2), 9), shrunk(enlarged(picture, 6), 4));
  EXPECT_EQ(narrowed(noise(200, 1, 3), 7).height, 1);
}

TEST(Jpeg, IsOneAndNearThePicture) {
  Picture smooth = filled_picture(64, 48, {});
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      set_pixel(smooth, x, y, {static_cast<std::uint8_t>(4 * x), static_cast<std::uint8_t>(5 * y), 128});
    }
  }
  const std::vector<std::byte> jpeg = encode_jpeg(smooth);
  ASSERT_GT(jpeg.size(), 200U);
  EXPECT_LT(jpeg.size(), smooth.samples.size() / 3);
  EXPECT_EQ(jpeg, encode_jpeg(smooth)) << "the same picture is the same bytes";
  EXPECT_EQ(jpeg[0], std::byte{0xFF});
  EXPECT_EQ(jpeg[1], std::byte{0xD8});
  EXPECT_EQ(jpeg[jpeg.size() - 2], std::byte{0xFF});
  EXPECT_EQ(jpeg[jpeg.size() - 1], std::byte{0xD9});
  EXPECT_THROW(encode_jpeg(Picture{}), std::invalid_argument);
}

TEST(Png, WhatDoesNotFitIsRefused) {
  Picture picture = noise(4, 4, 3);
  picture.samples.pop_back();
  EXPECT_THROW(encode_png(picture), std::invalid_argument);
  EXPECT_THROW(encode_png(Picture{0, 0, 3, {}}), std::invalid_argument);
  EXPECT_THROW(encode_png(noise(4, 4, 2)), std::invalid_argument);
}

TEST(Png, EveryShortenedFileIsRefused) {
  const std::vector<std::byte> whole = encode_png(noise(16, 16, 3));
  for (std::size_t size = 0; size + 16 < whole.size(); size += 7) {
    EXPECT_THROW(decode_png(std::span(whole).first(size), "short.png"), InputError) << size << " bytes";
  }
}

TEST(FetchRamp, RunsFromDarkBlueToYellow) {
  EXPECT_EQ(fetch_colour(-1.0), (Rgb{0x00, 0x20, 0x4D}));
  EXPECT_EQ(fetch_colour(9.0), (Rgb{0xFF, 0xEA, 0x46}));
  EXPECT_EQ(fetch_colour(4.0 / 9.0), (Rgb{0x70, 0x71, 0x73}));
}

TEST(ErrorRamp, IsWhiteAtZeroAndWeighsBothSignsTheSame) {
  const auto luma = [](Rgb c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
  EXPECT_EQ(error_colour(0.0), (Rgb{255, 255, 255}));
  double last = 256.0;
  for (int i = 0; i <= 100; ++i) {
    const double share = i / 100.0;
    EXPECT_NEAR(luma(error_colour(share)), luma(error_colour(-share)), 2.55) << share;
    EXPECT_LT(luma(error_colour(share)), last);
    last = luma(error_colour(share));
    if (i > 0) {
      EXPECT_GT(error_colour(share).r, error_colour(share).b) << "too bright must be vermilion";
      EXPECT_LT(error_colour(-share).r, error_colour(-share).b) << "too dark must be blue";
    }
  }
}

TEST(ColourMaps, MissingAndInvalidPixelsHaveColoursOfTheirOwn) {
  const std::vector<std::uint8_t> valid{1, 0, 1};
  const std::vector<float> values{0.5F, 0.5F, std::nanf("")};
  const std::vector<float> zeros(3, 0.0F);
  const PixelGrid grid{3, 1, valid};
  const Picture visibility = visibility_picture(grid, values);
  EXPECT_EQ(pixel(visibility, 0, 0), (Rgb{128, 128, 128}));
  EXPECT_EQ(pixel(visibility, 1, 0), kNoReceiver);
  EXPECT_EQ(pixel(visibility, 2, 0), kInvalid);
  const Picture error = error_picture(grid, values, zeros, 0.5);
  EXPECT_EQ(pixel(error, 0, 0), error_colour(1.0));
  EXPECT_EQ(pixel(error, 2, 0), kInvalid);
  for (int i = 0; i <= 1000; ++i) {
    for (const Rgb colour :
         {visibility_colour(i / 1000.0), error_colour(i / 500.0 - 1.0), fetch_colour(i / 1000.0)}) {
      EXPECT_NE(colour, kNoReceiver);
      EXPECT_NE(colour, kInvalid);
    }
  }
}

TEST(ColourMaps, RowsKeepTheirPlace) {
  const std::vector<std::uint8_t> valid(6, 1);
  const std::vector<std::uint32_t> fetches{0, 1, 2, 3, 4, 5};
  const Picture picture = fetch_picture({3, 2, valid}, fetches, 5.0);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(pixel(picture, i % 3, i / 3), fetch_colour(i / 5.0)) << i;
}

TEST(ColourMaps, ImagesOfAnotherSizeAreRefused) {
  const std::vector<std::uint8_t> valid(6, 1);
  const std::vector<float> five(5, 0.0F);
  const std::vector<float> six(6, 0.0F);
  EXPECT_THROW(visibility_picture({3, 2, valid}, five), std::invalid_argument);
  EXPECT_THROW(error_picture({3, 2, valid}, six, five, 1.0), std::invalid_argument);
}

TEST(Composition, HoldsEveryPictureOnceAndUnchanged) {
  const Picture a = noise(40, 20, 3);
  Picture b = a;
  b.samples[0] ^= 255;
  Picture c = a;
  c.samples[1] ^= 255;
  const Picture whole = compose({{"a", a, {}}, {"b", b, {}}, {"c", c, {}}}, 2);
  EXPECT_EQ(occurrences(whole, a), 1);
  EXPECT_EQ(occurrences(whole, b), 1);
  EXPECT_EQ(occurrences(whole, c), 1);
}

int dark_pixels(const Picture& picture, int rows) {
  int count = 0;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < picture.width; ++x) count += pixel(picture, x, y).r < 64 ? 1 : 0;
  }
  return count;
}

TEST(Composition, CaptionsAreDrawnAndStayOverTheirPicture) {
  const Picture white = filled_picture(60, 30, {255, 255, 255});
  EXPECT_EQ(dark_pixels(compose({{"", white, {}}}, 1), 30), 0);
  EXPECT_GT(dark_pixels(compose({{"error", white, {}}}, 1), 30), 40);
  // An endless caption, and one of no ASCII at all, are cut to the picture's width and do not reach its
  // margin.
  for (const std::string& caption : {std::string(500, 'W'), std::string(500, '\xC3')}) {
    const Picture cut = compose({{caption, white, {}}}, 1);
    EXPECT_GT(dark_pixels(cut, 30), 40);
    for (int x = cut.width - 8; x < cut.width; ++x) {
      for (int y = 0; y < cut.height; ++y)
        EXPECT_EQ(pixel(cut, x, y), (Rgb{255, 255, 255})) << x << ", " << y;
    }
  }
}

TEST(Composition, LegendsShowBothEndsOfTheRamp) {
  const Picture white = filled_picture(200, 30, {255, 255, 255});
  const Picture whole =
      compose({{"error", white, Legend{ramp_strip(error_colour, -1.0, 1.0), "-0.5", "+0.5"}}}, 1);
  EXPECT_GE(occurrences(whole, filled_picture(1, 8, error_colour(-1.0))), 1);
  EXPECT_GE(occurrences(whole, filled_picture(1, 8, error_colour(1.0))), 1);
}

TEST(Composition, EveryLineOfACaptionIsDrawnAboveItsPicture) {
  const Picture white = filled_picture(200, 30, {255, 255, 255});
  const Picture one = compose({{"error", white, {}}}, 1);
  const Picture two = compose({{"error\nerror", white, {}}}, 1);
  const int line = two.height - one.height;
  EXPECT_GT(line, 0);
  EXPECT_EQ(dark_pixels(two, two.height), 2 * dark_pixels(one, one.height));
  // Beside a longer caption, a short one leaves its second line to the legend.
  const Legend legend{ramp_strip(error_colour, -1.0, 1.0), "", ""};
  const Picture mixed = compose({{"a\nb", white, {}}, {"c", white, legend}}, 1);
  EXPECT_EQ(mixed.height - compose({{"a", white, {}}, {"c", white, legend}}, 1).height, 2 * line);
}

TEST(Composition, NarrowPicturesMakeRoomForTheirCaptions) {
  const std::string caption = "RMSE 0.123, 47.2 fetches";
  const Picture narrow = filled_picture(20, 30, {255, 255, 255});
  const Picture wide = filled_picture(600, 30, {255, 255, 255});
  const int all = dark_pixels(compose({{caption, wide, {}}}, 1), 30);
  EXPECT_EQ(dark_pixels(compose({{caption, narrow, {}}}, 1, caption_width(caption)), 30), all);
  EXPECT_LT(dark_pixels(compose({{caption, narrow, {}}}, 1, caption_width(caption) - 1), 30), all);
  EXPECT_EQ(caption_width(caption + "\nshort"), caption_width(caption));
}

TEST(Composition, UnequalPicturesAreRefused) {
  EXPECT_THROW(compose({{"a", noise(4, 4, 3), {}}, {"b", noise(5, 4, 3), {}}}, 2), std::invalid_argument);
  EXPECT_THROW(compose({}, 2), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::study
