#include "study/picture.h"

#include <png.h>

#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>

#include "input/input_error.h"

namespace penumbra::study {
namespace {

std::size_t offset(const Picture& picture, int x, int y) {
  return (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
          static_cast<std::size_t>(x)) *
         3;
}

// libpng's simplified interface, which handles its long jumps internally.
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

struct Palette {
  std::vector<std::uint8_t> colours;  // three samples each
  std::vector<std::uint8_t> indices;  // one per pixel
};

// Returns the palette of an RGB picture with few enough colours, in their order: neighbouring greys get
// neighbouring indices.
std::optional<Palette> palette_of(const Picture& picture) {
  constexpr std::size_t kMostColours = 256;
  if (picture.channels != 3) return std::nullopt;
  const auto colour_at = [&](std::size_t i) {
    return std::array{picture.samples[i], picture.samples[i + 1], picture.samples[i + 2]};
  };
  std::map<std::array<std::uint8_t, 3>, std::uint8_t> places;
  for (std::size_t i = 0; i < picture.samples.size(); i += 3) {
    places.emplace(colour_at(i), 0);
    if (places.size() > kMostColours) return std::nullopt;
  }
  Palette palette;
  for (auto& [colour, place] : places) {
    place = static_cast<std::uint8_t>(palette.colours.size() / 3);
    palette.colours.insert(palette.colours.end(), colour.begin(), colour.end());
  }
  for (std::size_t i = 0; i < picture.samples.size(); i += 3) {
    palette.indices.push_back(places.at(colour_at(i)));
  }
  return palette;
}

struct CoveredPixel {
  int index = 0;
  std::int64_t length = 0;  // of a line of sources * targets units
};

// For each target pixel of a line the source pixels that it covers.
std::vector<std::vector<CoveredPixel>> covered_pixels(int sources, int targets) {
  std::vector<std::vector<CoveredPixel>> covered(static_cast<std::size_t>(targets));
  for (int source = 0; source < sources; ++source) {
    const std::int64_t begin = std::int64_t{source} * targets;
    const std::int64_t end = begin + targets;
    for (std::int64_t target = begin / sources; target * sources < end; ++target) {
      const std::int64_t length = std::min(end, (target + 1) * sources) - std::max(begin, target * sources);
      covered[static_cast<std::size_t>(target)].push_back({source, length});
    }
  }
  return covered;
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

void place_picture(Picture& canvas, int left, int top, const Picture& picture) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) set_pixel(canvas, left + x, top + y, pixel(picture, x, y));
  }
}

void set_pixel(Picture& rgb, int x, int y, Rgb colour) {
  const std::size_t at = offset(rgb, x, y);
  rgb.samples[at] = colour.r;
  rgb.samples[at + 1] = colour.g;
  rgb.samples[at + 2] = colour.b;
}

Picture cropped(const Picture& rgb, const PictureWindow& window) {
  if (window.x < 0 || window.y < 0 || window.width < 1 || window.height < 1 ||
      window.x > rgb.width - window.width || window.y > rgb.height - window.height) {
    throw std::invalid_argument("a window extends beyond its picture");
  }
  Picture part = filled_picture(window.width, window.height, {});
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) set_pixel(part, x, y, pixel(rgb, window.x + x, window.y + y));
  }
  return part;
}

Picture enlarged(const Picture& rgb, int factor) {
  Picture large = filled_picture(rgb.width * factor, rgb.height * factor, {});
  for (int y = 0; y < large.height; ++y) {
    for (int x = 0; x < large.width; ++x) set_pixel(large, x, y, pixel(rgb, x / factor, y / factor));
  }
  return large;
}

Picture narrowed(const Picture& rgb, int width) {
  if (rgb.width <= width) return rgb;
  const std::int64_t area = std::int64_t{rgb.width} * rgb.height;
  const std::int64_t height = (std::int64_t{rgb.height} * width + rgb.width / 2) / rgb.width;
  Picture small = filled_picture(width, std::max(1, static_cast<int>(height)), {});
  const auto columns = covered_pixels(rgb.width, small.width);
  const auto rows = covered_pixels(rgb.height, small.height);
  const auto mean = [&](std::int64_t sum) { return static_cast<std::uint8_t>((sum + area / 2) / area); };
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      std::int64_t r = 0, g = 0, b = 0;
      for (const CoveredPixel& row : rows[static_cast<std::size_t>(y)]) {
        for (const CoveredPixel& column : columns[static_cast<std::size_t>(x)]) {
          const std::int64_t part = row.length * column.length;
          const Rgb one = pixel(rgb, column.index, row.index);
          r += part * one.r;
          g += part * one.g;
          b += part * one.b;
        }
      }
      set_pixel(small, x, y, {mean(r), mean(g), mean(b)});
    }
  }
  return small;
}

Picture shrunk(const Picture& rgb, int factor) {
  if (factor < 1 || rgb.width % factor != 0 || rgb.height % factor != 0) {
    throw std::invalid_argument("a picture is not a whole number of squares");
  }
  return narrowed(rgb, rgb.width / factor);
}

std::vector<std::byte> encode_png(const Picture& picture) {
  const std::size_t expected = static_cast<std::size_t>(picture.width) *
                               static_cast<std::size_t>(picture.height) *
                               static_cast<std::size_t>(picture.channels);
  if (expected == 0 || picture.samples.size() != expected) {
    throw std::invalid_argument("a picture's samples do not fit its size");
  }
  const std::optional<Palette> palette = palette_of(picture);
  PngImage png;
  png.image.format = palette ? PNG_FORMAT_RGB_COLORMAP : format_of(picture.channels);
  png.image.width = static_cast<png_uint_32>(picture.width);
  png.image.height = static_cast<png_uint_32>(picture.height);
  if (palette) png.image.colormap_entries = static_cast<png_uint_32>(palette->colours.size() / 3);
  const std::vector<std::uint8_t>& samples = palette ? palette->indices : picture.samples;
  const void* colours = palette ? palette->colours.data() : nullptr;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
  std::vector<std::byte> bytes(size);
  if (png_image_write_to_memory(&png.image, bytes.data(), &size, 0, samples.data(), 0, colours) == 0) {
    throw std::invalid_argument(std::string("libpng: ") + png.image.message);
  }
  bytes.resize(size);
  return bytes;
}

Picture decode_png(std::span<const std::byte> bytes, const std::string& name) {
  constexpr std::size_t kMostPixels = std::size_t{1} << 26;
  PngImage png;
  if (png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()) == 0) {
    throw InputError(name, std::string("is not a readable PNG: ") + png.image.message);
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

PackedPicture::PackedPicture(const Picture& picture) {
  if (picture.samples.empty()) return;
  png_ = encode_png(picture);
  png_.shrink_to_fit();
}

PackedPicture::PackedPicture(std::span<const std::byte> png) : png_(png.begin(), png.end()) {
  if (!png.empty()) decode_png(png, "a kept picture");
}

Picture PackedPicture::unpacked() const {
  return empty() ? Picture{} : decode_png(png_, "a kept picture");
}

}  // namespace penumbra::study
