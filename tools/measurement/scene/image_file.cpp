#include "scene/image_file.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <vector>

#include "input/input_error.h"
#include "input/text_file.h"

// The library is a header, whose warnings are not those of our code.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STBI_MAX_DIMENSIONS 8193
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
// The library copies zero bytes from a null pointer where a PNG's IDAT is empty, which C leaves undefined and
// C2y defines.
#ifdef __clang__
#pragma clang attribute push(__attribute__((no_sanitize("nonnull-attribute"))), apply_to = function)
#endif
#include <stb/stb_image.h>
#ifdef __clang__
#pragma clang attribute pop
#endif
#pragma GCC diagnostic pop

namespace penumbra::scene {
namespace {

constexpr int kChannels = 4;

static_assert(kLargestImageSide <= STBI_MAX_DIMENSIONS && kLargestHeightImageSide == STBI_MAX_DIMENSIONS);

[[noreturn]] void refuse(const std::string& name) {
  throw InputError(name, fmt::format("cannot be read as a picture: {}", stbi_failure_reason()),
                   "PNG, JPEG, TGA and BMP can be read");
}

}  // namespace

Texture decode_image(std::span<const std::byte> bytes, const std::string& name) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw InputError(name, "is larger than 2 GiB");
  }
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int length = static_cast<int>(bytes.size());
  int channels = 0;
  Texture texture;
  if (stbi_info_from_memory(data, length, &texture.width, &texture.height, &channels) == 0) refuse(name);
  if (texture.width > kLargestImageSide || texture.height > kLargestImageSide) {
    throw InputError(name, fmt::format("has {} x {} pixels; the limit is {} per side", texture.width,
                                       texture.height, kLargestImageSide));
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(data, length, &texture.width, &texture.height, &channels, kChannels),
      stbi_image_free);
  if (!pixels) refuse(name);
  const std::size_t size =
      static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height) * kChannels;
  texture.rgba.assign(pixels.get(), pixels.get() + size);
  return texture;
}

namespace {

std::string all_bytes(const std::filesystem::path& file) {
  require_regular_file(file);
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) throw InputError(file.string(), "cannot be opened");
  const std::optional<std::string> bytes = rest_of(stream);
  if (!bytes) throw InputError(file.string(), "cannot be read");
  return *bytes;
}

void check_height_image_size(const std::string& name, long long width, long long height) {
  const auto fits = [](long long side) { return side >= 2 && side <= kLargestHeightImageSide; };
  if (fits(width) && fits(height)) return;
  throw InputError(name,
                   fmt::format("cannot have {} x {} samples; 2 to {} per side can be read", width, height,
                               kLargestHeightImageSide),
                   "export it with another resolution; of RAW say the size that it has: --raw-size "
                   "WIDTHxDEPTH");
}

// The library has no reason for some files.
std::string reason() {
  const char* text = stbi_failure_reason();
  return text == nullptr || *text == '\0' ? "" : fmt::format(" ({})", text);
}

HeightImage decode_height_png(std::span<const std::byte> bytes, const std::string& name) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError(name, "is larger than 2 GiB");
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int length = static_cast<int>(bytes.size());
  HeightImage image;
  int channels = 0;
  if (stbi_info_from_memory(data, length, &image.width, &image.height, &channels) == 0) {
    throw InputError(
        name,
        "cannot be read as an image of heights: it is damaged, incomplete or of another format" + reason(),
        "PNG with 16 bits a channel can be read, and RAW: 16-bit numbers without a header, in a file named "
        ".raw or .r16");
  }
  check_height_image_size(name, image.width, image.height);
  if (stbi_is_16_bit_from_memory(data, length) == 0) {
    throw InputError(name, "has 8 bits a channel, and 256 steps of height make terraces of a slope",
                     "export the heights with 16 bits, as PNG or RAW");
  }
  if (channels != 1) {
    throw InputError(name, fmt::format("has {} channels, and which one is the height is unknown", channels),
                     "export the heights as grey with 16 bits, without colour and without alpha");
  }
  const std::unique_ptr<stbi_us, void (*)(void*)> samples(
      stbi_load_16_from_memory(data, length, &image.width, &image.height, &channels, 1), stbi_image_free);
  if (!samples) {
    throw InputError(name,
                     "cannot be read as an image of heights: the file is damaged or incomplete" + reason(),
                     "export it again");
  }
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  for (std::size_t row = height; row-- > 0;)
    image.samples.insert(image.samples.end(), samples.get() + row * width, samples.get() + (row + 1) * width);
  return image;
}

HeightImage decode_height_raw(std::span<const std::byte> bytes, const std::string& name,
                              std::optional<ImageSize> raw_size) {
  const std::size_t count = bytes.size() / 2;
  const std::string holds = fmt::format("has {} bytes, ", bytes.size());
  if (!raw_size) {
    const auto side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count))));
    if (bytes.size() != 2 * static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {
      throw InputError(name, holds + "which are not a square of 16-bit samples",
                       "say its size: --raw-size WIDTHxDEPTH. RAW files with 8 bits a sample cannot be read");
    }
    raw_size = ImageSize{side, side};
  }
  check_height_image_size(name, raw_size->width, raw_size->height);
  const std::size_t wanted =
      static_cast<std::size_t>(raw_size->width) * static_cast<std::size_t>(raw_size->height);
  if (bytes.size() != 2 * wanted) {
    throw InputError(name, holds + fmt::format("and {} x {} samples of 16 bits have {}", raw_size->width,
                                               raw_size->height, 2 * wanted));
  }
  HeightImage image{raw_size->width, raw_size->height, {}};
  image.samples.reserve(wanted);
  for (std::size_t i = 0; i < wanted; ++i) {
    image.samples.push_back(static_cast<std::uint16_t>(std::to_integer<unsigned>(bytes[2 * i]) |
                                                       std::to_integer<unsigned>(bytes[2 * i + 1]) << 8U));
  }
  return image;
}

}  // namespace

HeightImage decode_height_image(std::span<const std::byte> bytes, const std::string& name,
                                std::optional<ImageSize> raw_size) {
  std::string extension = std::filesystem::path(name).extension().string();
  for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  if (extension == ".raw" || extension == ".r16") return decode_height_raw(bytes, name, raw_size);
  if (raw_size)
    throw InputError(name, "is not a RAW file, which alone are told their size", "leave out --raw-size");
  return decode_height_png(bytes, name);
}

HeightImage read_height_image(const std::filesystem::path& file, std::optional<ImageSize> raw_size) {
  const std::string bytes = all_bytes(file);
  return decode_height_image(std::as_bytes(std::span<const char>(bytes)), file.string(), raw_size);
}

Texture read_image(const std::filesystem::path& file) {
  const std::string bytes = all_bytes(file);
  return decode_image(std::as_bytes(std::span<const char>(bytes)), file.string());
}

}  // namespace penumbra::scene
