#include "study/picture.h"

#include <png.h>

#include <cstring>
#include <stdexcept>

#include "input/input_error.h"

namespace penumbra::study {
namespace {

std::size_t offset(const Picture& picture, int x, int y) {
  return (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
          static_cast<std::size_t>(x)) *
         3;
}

// libpng's simplified interface: it keeps its own long jumps to itself.
struct PngImage {
  png_image image{};

  PngImage() { image.version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(&image); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
};

png_uint_32 format_of(int channels) {
  if (channels == 1) return PNG_FORMAT_GRAY;
  if (channels == 3) return PNG_FORMAT_RGB;
  if (channels == 4) return PNG_FORMAT_RGBA;
  throw std::invalid_argument("a picture has 1, 3 or 4 channels");
}

}  // namespace

Picture filled_picture(int width, int height, Rgb colour) {
  Picture picture{width, height, 3, {}};
  picture.samples.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) set_pixel(picture, x, y, colour);
  }
  return picture;
}

Rgb pixel(const Picture& rgb, int x, int y) {
  const std::size_t at = offset(rgb, x, y);
  return {rgb.samples[at], rgb.samples[at + 1], rgb.samples[at + 2]};
}

void set_pixel(Picture& rgb, int x, int y, Rgb colour) {
  const std::size_t at = offset(rgb, x, y);
  rgb.samples[at] = colour.r;
  rgb.samples[at + 1] = colour.g;
  rgb.samples[at + 2] = colour.b;
}

std::vector<std::byte> encode_png(const Picture& picture) {
  PngImage png;
  png.image.format = format_of(picture.channels);
  png.image.width = static_cast<png_uint_32>(picture.width);
  png.image.height = static_cast<png_uint_32>(picture.height);
  const std::size_t expected = static_cast<std::size_t>(picture.width) *
                               static_cast<std::size_t>(picture.height) *
                               static_cast<std::size_t>(picture.channels);
  if (expected == 0 || picture.samples.size() != expected) {
    throw std::invalid_argument("a picture's samples do not fit its size");
  }
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
  std::vector<std::byte> bytes(size);
  if (png_image_write_to_memory(&png.image, bytes.data(), &size, 0, picture.samples.data(), 0, nullptr) ==
      0) {
    throw std::invalid_argument(std::string("libpng: ") + png.image.message);
  }
  bytes.resize(size);
  return bytes;
}

Picture decode_png(std::span<const std::byte> bytes, const std::string& name) {
  constexpr std::size_t kMostPixels = std::size_t{1} << 26;
  PngImage png;
  if (png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()) == 0) {
    throw InputError(name, std::string("is no readable PNG: ") + png.image.message);
  }
  const std::size_t pixels = std::size_t{png.image.width} * png.image.height;
  if (pixels > kMostPixels) throw InputError(name, "has more than 2^26 pixels");

  Picture picture;
  picture.width = static_cast<int>(png.image.width);
  picture.height = static_cast<int>(png.image.height);
  const bool colour = (png.image.format & PNG_FORMAT_FLAG_COLOR) != 0;
  const bool alpha = (png.image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  picture.channels = alpha ? 4 : (colour ? 3 : 1);
  png.image.format = format_of(picture.channels);
  picture.samples.resize(pixels * static_cast<std::size_t>(picture.channels));
  if (png_image_finish_read(&png.image, nullptr, picture.samples.data(), 0, nullptr) == 0) {
    throw InputError(name, std::string("is a broken PNG: ") + png.image.message);
  }
  return picture;
}

}  // namespace penumbra::study
