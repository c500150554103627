#include "scene/image_file.h"

#include <fmt/format.h>

#include <fstream>
#include <limits>
#include <memory>
#include <vector>

#include "input/input_error.h"
#include "input/text_file.h"

// The library is a header; its own warnings are not ours.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STBI_MAX_DIMENSIONS 8192
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
// It copies zero bytes from a null pointer where a PNG's IDAT is empty, which C leaves undefined and C2y
// defines.
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

static_assert(kLargestImageSide == STBI_MAX_DIMENSIONS);

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

Texture read_image(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) throw InputError(file.string(), "cannot be opened");
  const std::optional<std::string> bytes = rest_of(stream);
  if (!bytes) throw InputError(file.string(), "cannot be read");
  return decode_image(std::as_bytes(std::span<const char>(*bytes)), file.string());
}

}  // namespace penumbra::scene
