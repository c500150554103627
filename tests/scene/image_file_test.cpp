// Tests pictures from files: what the bytes say, and every way they are refused.
#include "scene/image_file.h"

#include <gmock/gmock.h>

#include <fstream>

#include "input/input_error_matcher.h"
#include "reference/scratch_folder.h"

namespace penumbra::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::byte> bytes_of(const std::vector<int>& values) {
  std::vector<std::byte> bytes;
  bytes.reserve(values.size());
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

// An uncompressed TGA of 24 bits with rows from the top: an 18-byte header, then blue, green and red of each
// pixel.
std::vector<std::byte> tga(int width, int height, const std::vector<int>& blue_green_red) {
  std::vector<int> file{0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  file.insert(file.end(), {width & 255, width >> 8, height & 255, height >> 8, 24, 0x20});
  file.insert(file.end(), blue_green_red.begin(), blue_green_red.end());
  return bytes_of(file);
}

TEST(ImageFile, RowsComeFromTheTopAndColoursInOrder) {
  const Texture texture = decode_image(tga(2, 2, {3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10}), "four.tga");
  EXPECT_EQ(texture.width, 2);
  EXPECT_EQ(texture.height, 2);
  EXPECT_THAT(texture.rgba, ElementsAre(1, 2, 3, 255, 4, 5, 6, 255, 7, 8, 9, 255, 10, 11, 12, 255));
}

TEST(ImageFile, AFileSaysTheSameAsItsBytes) {
  const reference::ScratchFolder folder;
  const std::vector<std::byte> bytes = tga(1, 1, {30, 20, 10});
  const std::filesystem::path file = folder.path() / "one.tga";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  EXPECT_THAT(read_image(file).rgba, ElementsAre(10, 20, 30, 255));
}

TEST(ImageFile, WhatIsNoPictureIsNamed) {
  expect_input_error(
      [] {
        decode_image(bytes_of({'h', 'e', 'l', 'l', 'o'}), "noise.png");
      },
      HasSubstrs("noise.png", "PNG, JPEG, TGA and BMP"));
  expect_input_error([] { decode_image({}, "empty.png"); }, HasSubstr("empty.png"));
  expect_input_error([] { read_image("absent.png"); }, HasSubstrs("absent.png", "cannot be opened"));
  expect_input_error([] { read_image(std::filesystem::temp_directory_path()); },
                     HasSubstr("cannot be opened"));
}

TEST(ImageFile, APictureThatEndsEarlyIsRefused) {
  std::vector<std::byte> png =
      bytes_of({0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13, 'I', 'H', 'D', 'R', 0,
                0,    0,   4,   0,   0,    0,    4,    8,    2, 0, 0, 0,  0,   0,   0,   0});
  expect_input_error([&] { decode_image(png, "half.png"); }, HasSubstr("half.png"));
}

TEST(ImageFile, APictureBeyondTheLimitIsRefusedBeforeItIsRead) {
  expect_input_error(
      [] {
        decode_image(tga(kLargestImageSide + 1, 1, {1, 2, 3}), "wide.tga");
      },
      HasSubstr("wide.tga"));
}

#ifdef __linux__
TEST(ImageFile, OneThatCannotBeReadToItsEndIsRefused) {
  expect_input_error([] { read_image("/proc/self/mem"); }, HasSubstr("cannot be read"));
}
#endif

}  // namespace
}  // namespace penumbra::scene
