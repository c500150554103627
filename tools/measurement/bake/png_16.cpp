#include "bake/png_16.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace penumbra::bake {
namespace {

[[noreturn]] void fail(png_structp /*png*/, png_const_charp message) {
  throw std::invalid_argument(std::string("libpng: ") + message);
}

void ignore(png_structp /*png*/, png_const_charp /*message*/) {}

void append(png_structp png, png_bytep data, png_size_t length) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
  const auto* first = reinterpret_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), first, first + length);
}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png_create_info_struct(png);

  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

}  // namespace

std::vector<std::byte> encode_png_16(int width, int height, int channels,
                                     std::span<const std::uint16_t> samples) {
  const bool whole = width > 0 && height > 0 && (channels == 1 || channels == 4) &&
                     samples.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                                           static_cast<std::size_t>(channels);
  if (!whole) throw std::invalid_argument("samples do not fit the picture's size");
  std::vector<std::byte> bytes;
  const Writer writer;
  png_set_write_fn(writer.png, &bytes, append, nullptr);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 16,
               channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(writer.png, writer.info);
  const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
  std::vector<png_byte> big_endian(2 * row);
  for (std::size_t y = static_cast<std::size_t>(height);
       y-- > 0;) {  // the file begins with the picture's top row
    for (std::size_t i = 0; i < row; ++i) {
      const unsigned sample = samples[y * row + i];
      big_endian[2 * i] = static_cast<png_byte>(sample >> 8U);
      big_endian[2 * i + 1] = static_cast<png_byte>(sample & 0xFFU);
    }
    png_write_row(writer.png, big_endian.data());
  }
  png_write_end(writer.png, writer.info);
  return bytes;
}

}  // namespace penumbra::bake
