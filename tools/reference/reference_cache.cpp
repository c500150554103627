#include "reference/reference_cache.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>
#include <type_traits>
#include <utility>

#include "input/input_error.h"
#include "platform/atomic_file.h"
#include "platform/content_hash.h"
#include "platform/terminal.h"

namespace penumbra::reference {
namespace {

// An entry: title, key, payload, and the hash of these three.
constexpr std::string_view image_title = "penumbra reference image 1\n";
constexpr std::string_view beginning_title = "penumbra reference rows 1\n";
constexpr std::size_t hash_size = 32;

std::string hash_of(std::string_view content) {
  return platform::ContentHash().update(content).hex().substr(0, hash_size);
}

class EntryWriter {
 public:
  EntryWriter(std::string_view title, const std::string& key) : content_(std::string(title) + key) {}

  template <typename Element>
  void append(std::span<const Element> elements) {
    static_assert(std::is_trivially_copyable_v<Element>);
    content_.append(reinterpret_cast<const char*>(elements.data()), elements.size_bytes());
  }
  template <typename Value>
  void append(const Value& value) {
    append(std::span<const Value>(&value, 1));
  }

  void write(const std::filesystem::path& file) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) {
      throw InputError(file.parent_path().string(), "the cache folder cannot be made: " + error.message(),
                       "name another with the environment variable PENUMBRA_CACHE");
    }
    content_ += hash_of(content_);
    platform::write_file_atomically(file, content_);
  }

 private:
  std::string content_;
};

// The payload of a whole entry with this title and key; nothing for any other file.
std::optional<std::string> read_payload(const std::filesystem::path& file, std::string_view title,
                                        const std::string& key) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  const std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::string head = std::string(title) + key;
  if (content.size() < head.size() + hash_size || !content.starts_with(head)) return std::nullopt;
  const std::string_view hashed(content.data(), content.size() - hash_size);
  if (hash_of(hashed) != content.substr(hashed.size())) return std::nullopt;
  return std::string(hashed.substr(head.size()));
}

class PayloadReader {
 public:
  explicit PayloadReader(std::string_view payload) : rest_(payload) {}

  template <typename Element>
  std::vector<Element> take(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<Element>);
    if (count > rest_.size() / sizeof(Element)) {
      whole_ = false;
      return {};
    }
    std::vector<Element> elements(count);
    std::memcpy(elements.data(), rest_.data(), count * sizeof(Element));
    rest_.remove_prefix(count * sizeof(Element));
    return elements;
  }
  template <typename Value>
  Value take() {
    const std::vector<Value> one = take<Value>(1);
    return one.empty() ? Value{} : one.front();
  }

  bool exhausted() const { return whole_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool whole_ = true;
};

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
  const std::optional<std::string> payload = read_payload(image_file(key), image_title, key);
  if (!payload) return std::nullopt;
  PayloadReader reader(*payload);
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

void ReferenceCache::store(const std::string& key, const VisibilityImage& image) const {
  EntryWriter entry(image_title, key);
  entry.append(static_cast<std::int32_t>(image.width));
  entry.append(static_cast<std::int32_t>(image.height));
  entry.append(static_cast<std::int32_t>(image.samples));
  entry.append(image.noise_floor);
  entry.append(std::span<const float>(image.visibility));
  entry.append(std::span<const std::uint8_t>(image.valid));
  entry.write(image_file(key));
}

std::vector<HalfCounts> ReferenceCache::find_beginning(const std::string& key) const {
  const std::optional<std::string> payload = read_payload(beginning_file(key), beginning_title, key);
  if (!payload || payload->size() % sizeof(HalfCounts) != 0) return {};
  return PayloadReader(*payload).take<HalfCounts>(payload->size() / sizeof(HalfCounts));
}

void ReferenceCache::store_beginning(const std::string& key, std::span<const HalfCounts> counts) const {
  EntryWriter entry(beginning_title, key);
  entry.append(counts);
  entry.write(beginning_file(key));
}

void ReferenceCache::drop_beginning(const std::string& key) const noexcept {
  std::error_code ignored;
  std::filesystem::remove(beginning_file(key), ignored);
}

}  // namespace penumbra::reference
