// Tests images of heights: what their bytes say, by way of another process too, and every way they are
// refused.
#include "scene/image_file.h"

#include <gmock/gmock.h>
#include <png.h>

#include <algorithm>
#include <fstream>
#include <string_view>

#include "input/input_error_matcher.h"
#include "reference/scratch_folder.h"
#include "scene/scene_message.h"

namespace penumbra::scene {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::byte> raw(const std::vector<int>& samples) {
  std::vector<std::byte> bytes;
  for (const int sample : samples) {
    bytes.push_back(static_cast<std::byte>(sample & 255));
    bytes.push_back(static_cast<std::byte>(sample >> 8));
  }
  return bytes;
}

// The file is written by libpng's own simplified interface: 16 bits a sample in its linear formats, else 8.
std::vector<std::byte> png(int width, int height, const std::vector<std::uint16_t>& samples,
                           png_uint_32 format = PNG_FORMAT_LINEAR_Y) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  std::vector<png_byte> low(samples.begin(), samples.end());
  const bool sixteen_bits = (format & PNG_FORMAT_FLAG_LINEAR) != 0;
  const void* pixels = sixteen_bits ? static_cast<const void*>(samples.data()) : low.data();
  std::vector<std::byte> bytes(PNG_IMAGE_PNG_SIZE_MAX(image));
  png_alloc_size_t size = bytes.size();
  EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0, nullptr), 0)
      << image.message;
  bytes.resize(size);
  return bytes;
}

TEST(HeightImage, PngGivesItsSamplesUnchangedFromTheBottomRow) {
  const HeightImage image = decode_height_image(png(3, 2, {0, 1, 256, 40000, 65534, 65535}), "a.png", {});
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_THAT(image.samples, ElementsAre(40000, 65534, 65535, 0, 1, 256));
}

TEST(HeightImage, RawHasTheLowByteFirstAndIsSquareUnlessItsSizeIsSaid) {
  const std::vector<std::byte> bytes = raw({0, 1, 256, 65535});
  for (const char* name : {"a.raw", "a.r16", "a.RAW"}) {
    const HeightImage square = decode_height_image(bytes, name, {});
    EXPECT_EQ(square.width, 2);
    EXPECT_EQ(square.height, 2);
    EXPECT_THAT(square.samples, ElementsAre(0, 1, 256, 65535));
  }
  const HeightImage wide = decode_height_image(raw({0, 1, 2, 3, 4, 5}), "a.raw", ImageSize{3, 2});
  EXPECT_EQ(wide.width, 3);
  EXPECT_EQ(wide.height, 2);
}

TEST(HeightImage, IsRefusedByNameAndReason) {
  const auto refuse = [](std::span<const std::byte> bytes, const char* name, std::optional<ImageSize> size,
                         const auto& says) {
    expect_input_error([&] { decode_height_image(bytes, name, size); }, AllOf(HasSubstr(name), says));
  };
  refuse(png(2, 2, {1, 2, 3, 4}, PNG_FORMAT_GRAY), "eight.png", {}, HasSubstr("8 bits"));
  refuse(png(1, 4, {1, 2, 3, 4}), "thin.png", {}, HasSubstr("1 x 4 samples"));
  refuse(png(2, 2, {1, 2, 3, 4}), "told.png", ImageSize{2, 2}, HasSubstr("--raw-size"));
  refuse(raw({1, 2, 3}), "three.raw", {}, HasSubstrs("6 bytes", "--raw-size"));
  refuse(raw({1, 2, 3, 4}), "four.raw", ImageSize{3, 2}, HasSubstrs("8 bytes", "12"));
  refuse(raw({1, 2, 3, 4}), "four.raw", ImageSize{0, 0}, HasSubstr("0 x 0"));
  refuse(raw({1, 2, 3, 4}), "four.raw", ImageSize{-2, -2}, HasSubstr("-2 x -2"));
  refuse(raw({1, 2, 3, 4}), "four.raw", ImageSize{2, 8194}, HasSubstr("8193 per side"));
  refuse({}, "empty.raw", {}, HasSubstr("0 x 0"));
  refuse({}, "empty.png", {}, HasSubstr("cannot be read"));
  refuse(raw({1}), "one.raw", {}, HasSubstr("1 x 1"));
  refuse(png(2, 2, std::vector<std::uint16_t>(8, 65535), PNG_FORMAT_LINEAR_Y_ALPHA), "alpha.png", {},
         HasSubstrs("2 channels", "without colour and without alpha"));
  refuse(png(2, 2, std::vector<std::uint16_t>(12, 300), PNG_FORMAT_LINEAR_RGB), "colour.png", {},
         HasSubstrs("3 channels", "without colour and without alpha"));
}

TEST(HeightImage, ADamagedPngIsNotTakenForAnotherFormat) {
  const std::vector<std::byte> whole = png(3, 2, {0, 1, 256, 40000, 65534, 65535});
  const auto refuse = [](std::span<const std::byte> bytes, const auto& says) {
    expect_input_error([&] { decode_height_image(bytes, "heights.png", {}); },
                       AllOf(HasSubstr("heights.png: cannot be read as an image of heights"), says,
                             testing::Not(HasSubstr("()"))));
  };
  // These bytes are the signature, IHDR's length and name, and its beginning.
  constexpr std::size_t size_and_depth = 8 + 8 + 9;
  constexpr std::size_t end = 12;  // IEND, which is empty
  for (std::size_t length = size_and_depth; length < whole.size() - end; ++length)
    refuse(std::span(whole).first(length),
           HasSubstrs("the file is damaged or incomplete", "export it again"));
  std::vector<std::byte> damaged = whole;
  const std::string_view name = "IDAT";
  const auto data = std::search(damaged.begin(), damaged.end(), name.begin(), name.end(),
                                [](std::byte byte, char letter) { return byte == std::byte(letter); });
  ASSERT_NE(data, damaged.end());
  *(data + 4) = std::byte{0xff};  // the header of the compressed samples
  refuse(damaged, HasSubstrs("the file is damaged or incomplete", "export it again"));
  for (std::size_t length = 0; length < size_and_depth; ++length)
    refuse(std::span(whole).first(length), HasSubstrs("damaged, incomplete or of another format", ".r16"));
  refuse(raw({1, 2, 3, 4}), HasSubstrs("damaged, incomplete or of another format", ".r16"));
}

TEST(HeightImage, AnAnswerOfAnotherProcessIsBelievedOnlyWhereItIsWhole) {
  const HeightImage image{2, 3, {1, 2, 3, 4, 5, 6}};
  const HeightImage back = decode_heights(encode(image));
  EXPECT_EQ(back.width, 2);
  EXPECT_EQ(back.height, 3);
  EXPECT_EQ(back.samples, image.samples);
  for (const HeightImage& wrong : {HeightImage{2, 3, {1, 2, 3}}, HeightImage{1, 6, image.samples},
                                   HeightImage{-2, -3, image.samples}, HeightImage{}})
    EXPECT_THROW(decode_heights(encode(wrong)), std::invalid_argument);
  EXPECT_THROW(decode_heights(encode(image).substr(0, 20)), std::invalid_argument);
}

TEST(HeightImage, AFileSaysTheSameAsItsBytes) {
  const reference::ScratchFolder folder;
  const std::vector<std::byte> bytes = raw({9, 8, 7, 6});
  const std::filesystem::path file = folder.path() / "four.raw";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  EXPECT_THAT(read_height_image(file, {}).samples, ElementsAre(9, 8, 7, 6));
  expect_input_error([&] { read_height_image(folder.path() / "absent.raw", {}); }, HasSubstr("absent.raw"));
}

}  // namespace
}  // namespace penumbra::scene
