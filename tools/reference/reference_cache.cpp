#include "reference/reference_cache.h"

#include <cstdint>
#include <string_view>
#include <utility>

#include "platform/terminal.h"
#include "reference/cache_entry.h"

namespace penumbra::reference {
namespace {

constexpr std::string_view image_title = "penumbra reference image 1\n";
constexpr std::string_view beginning_title = "penumbra reference rows 1\n";

}  // namespace

ReferenceCache::ReferenceCache(std::filesystem::path directory)
    : directory_(directory.empty() ? platform::cache_directory() / "reference" : std::move(directory)) {}

std::filesystem::path ReferenceCache::image_file(const std::string& key) const {
  return directory_ / (key + ".visibility");
}

std::filesystem::path ReferenceCache::beginning_file(const std::string& key) const {
  return directory_ / (key + ".rows");
}

std::optional<VisibilityImage> ReferenceCache::find(const std::string& key) const {
  std::optional<CacheEntryReader> entry = CacheEntryReader::open(image_file(key), image_title, key);
  if (!entry) return std::nullopt;
  CacheEntryReader& reader = *entry;
  VisibilityImage image;
  image.width = reader.take<std::int32_t>();
  image.height = reader.take<std::int32_t>();
  image.samples = reader.take<std::int32_t>();
  image.noise_floor = reader.take<double>();
  if (image.width < 0 || image.height < 0) return std::nullopt;
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.visibility = reader.take<float>(pixels);
  image.valid = reader.take<std::uint8_t>(pixels);
  if (!reader.exhausted()) return std::nullopt;
  return image;
}

bool ReferenceCache::store(const std::string& key, const VisibilityImage& image) const {
  CacheEntryWriter entry(image_title, key);
  entry.append(static_cast<std::int32_t>(image.width));
  entry.append(static_cast<std::int32_t>(image.height));
  entry.append(static_cast<std::int32_t>(image.samples));
  entry.append(image.noise_floor);
  entry.append(std::span<const float>(image.visibility));
  entry.append(std::span<const std::uint8_t>(image.valid));
  return entry.write(image_file(key));
}

std::vector<HalfCounts> ReferenceCache::find_beginning(const std::string& key) const {
  std::optional<CacheEntryReader> entry = CacheEntryReader::open(beginning_file(key), beginning_title, key);
  if (!entry || entry->bytes_left() % sizeof(HalfCounts) != 0) return {};
  return entry->take<HalfCounts>(entry->bytes_left() / sizeof(HalfCounts));
}

bool ReferenceCache::store_beginning(const std::string& key, std::span<const HalfCounts> counts) const {
  CacheEntryWriter entry(beginning_title, key);
  entry.append(counts);
  return entry.write(beginning_file(key));
}

void ReferenceCache::drop_beginning(const std::string& key) const {
  std::error_code ignored;
  std::filesystem::remove(beginning_file(key), ignored);
}

}  // namespace penumbra::reference
