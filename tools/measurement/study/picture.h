// Eight-bit pictures, row 0 at the top, and their PNG form.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace penumbra::study {

struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  bool operator==(const Rgb&) const = default;
};

struct Picture {
  int width = 0;
  int height = 0;
  int channels = 3;                   // 1 grey, 3 RGB, 4 RGBA (alpha not premultiplied)
  std::vector<std::uint8_t> samples;  // width * height * channels

  bool operator==(const Picture&) const = default;
};

// A part of a picture in pixels, from its left upper corner.
struct PictureWindow {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool contains(int column, int row) const {
    return column >= x && column < x + width && row >= y && row < y + height;
  }
  bool operator==(const PictureWindow&) const = default;
};

Picture filled_picture(int width, int height, Rgb colour);
Rgb pixel(const Picture& rgb, int x, int y);
void set_pixel(Picture& rgb, int x, int y, Rgb colour);
void place_picture(Picture& canvas, int left, int top, const Picture& picture);

// Returns the window's pixels. Throws std::invalid_argument when it is empty or reaches beyond the picture.
Picture cropped(const Picture& rgb, const PictureWindow& window);

// Returns every pixel as a square of `factor` pixels.
Picture enlarged(const Picture& rgb, int factor);

// Returns every square of `factor` pixels as their mean. Throws std::invalid_argument where squares do not
// fill it.
Picture shrunk(const Picture& rgb, int factor);

// The whole picture scaled down to this width, each pixel the mean of the area below it; itself where it is
// no wider.
Picture narrowed(const Picture& rgb, int width);

// The same picture gives the same bytes. RGB with at most 256 colours is written with a palette. Throws
// std::invalid_argument when the sample count does not fit.
std::vector<std::byte> encode_png(const Picture& picture);

// Returns a baseline JPEG of quality 90, for large pictures of many colours. Throws as encode_png() does.
std::vector<std::byte> encode_jpeg(const Picture& picture);

// Throws InputError naming `name` for bytes that are no PNG, cut short or larger than 2^26 pixels. Palettes
// and 16-bit channels come back as 8-bit grey, RGB or RGBA.
Picture decode_png(std::span<const std::byte> bytes, const std::string& name);

// A picture held as PNG: a study has thousands of them, and in this form each is a tenth of its size.
class PackedPicture {
 public:
  PackedPicture() = default;
  // Packs the picture; one without samples is empty. Throws as encode_png() does.
  PackedPicture(const Picture& picture);  // NOLINT(google-explicit-constructor)
  // Throws InputError for bytes that are no PNG.
  explicit PackedPicture(std::span<const std::byte> png);

  bool empty() const { return png_.empty(); }
  std::span<const std::byte> png() const { return png_; }
  Picture unpacked() const;
  operator Picture() const { return unpacked(); }  // NOLINT(google-explicit-constructor)

  friend bool operator==(const PackedPicture&, const PackedPicture&) = default;

 private:
  std::vector<std::byte> png_;
};

}  // namespace penumbra::study
