#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include <stdexcept>

#include "study/picture.h"

namespace penumbra::study {

std::vector<std::byte> encode_jpeg(const Picture& picture) {
  constexpr int kQuality = 75;
  const std::size_t samples = static_cast<std::size_t>(picture.width) *
                              static_cast<std::size_t>(picture.height) *
                              static_cast<std::size_t>(picture.channels);
  if (samples == 0 || picture.samples.size() != samples) {
    throw std::invalid_argument("a picture does not hold width x height pixels");
  }
  std::vector<std::byte> bytes;
  const auto append = [](void* context, void* data, int size) {
    auto* all = static_cast<std::vector<std::byte>*>(context);
    const auto* first = static_cast<const std::byte*>(data);
    all->insert(all->end(), first, first + size);
  };
  stbi_write_jpg_to_func(append, &bytes, picture.width, picture.height, picture.channels,
                         picture.samples.data(), kQuality);
  return bytes;
}

}  // namespace penumbra::study
