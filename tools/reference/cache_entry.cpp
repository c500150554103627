#include "reference/cache_entry.h"

#include <fstream>

#include "input/input_error.h"
#include "input/text_file.h"
#include "platform/atomic_file.h"
#include "platform/content_hash.h"

namespace penumbra::reference {
namespace {

constexpr std::size_t hash_size = 32;

std::string hash_of(std::string_view content) {
  return platform::ContentHash().update(content).hex().substr(0, hash_size);
}

}  // namespace

bool CacheEntryWriter::write(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error) return false;
  content_ += hash_of(content_);
  try {
    platform::write_file_atomically(file, content_);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

std::optional<CacheEntryReader> CacheEntryReader::open(const std::filesystem::path& file,
                                                       std::string_view title, const std::string& key) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  const std::optional<std::string> read = rest_of(stream);
  if (!read) return std::nullopt;
  const std::string& content = *read;
  const std::string head = std::string(title) + key;
  if (content.size() < head.size() + hash_size || !content.starts_with(head)) return std::nullopt;
  const std::string_view hashed(content.data(), content.size() - hash_size);
  if (hash_of(hashed) != content.substr(hashed.size())) return std::nullopt;
  return CacheEntryReader(std::string(hashed.substr(head.size())));
}

}  // namespace penumbra::reference
