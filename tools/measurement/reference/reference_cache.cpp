#include "reference/reference_cache.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

#include "platform/byte_stream.h"

namespace penumbra::reference {
namespace {

constexpr std::string_view image_kind = "visibility";

}  // namespace

ReferenceCache::ReferenceCache(std::filesystem::path directory)
    : store_(directory.empty() ? platform::cache_directory("reference") : std::move(directory)) {}

std::filesystem::path ReferenceCache::image_file(const std::string& key) const {
  return store_.file(image_kind, key);
}

std::optional<VisibilityImage> ReferenceCache::find(const std::string& key) const {
  const std::optional<std::string> entry = store_.find(image_kind, key);
  if (!entry) return std::nullopt;
  platform::ByteReader reader(*entry);
  VisibilityImage image;
  image.width = reader.value<std::int32_t>();
  image.height = reader.value<std::int32_t>();
  image.samples = reader.value<std::int32_t>();
  image.noise_floor = reader.value<double>();
  image.visibility = reader.values<float>();
  image.valid = reader.values<std::uint8_t>();
  if (!reader.exhausted() || image.width < 0 || image.height < 0) return std::nullopt;
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.visibility.size() != pixels || image.valid.size() != pixels) return std::nullopt;
  const bool plausible = std::all_of(image.visibility.begin(), image.visibility.end(),
                                     [](float share) { return share >= 0.0F && share <= 1.0F; });
  if (!plausible || !(image.noise_floor >= 0.0 && image.noise_floor <= 1.0)) return std::nullopt;
  return image;
}

bool ReferenceCache::store(const std::string& key, const VisibilityImage& image) const {
  platform::ByteWriter writer;
  writer.value(static_cast<std::int32_t>(image.width));
  writer.value(static_cast<std::int32_t>(image.height));
  writer.value(static_cast<std::int32_t>(image.samples));
  writer.value(image.noise_floor);
  writer.values(image.visibility);
  writer.values(image.valid);
  return store_.store(image_kind, key, writer.take());
}

}  // namespace penumbra::reference
