// References cached on disk (platform/cache_store.h) under the hash of everything they depend on. Several
// processes may share a directory: writers of one key write the same bytes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "platform/cache_store.h"
#include "reference/visibility_image.h"

namespace penumbra::reference {

class ReferenceCache {
 public:
  // An empty path means "reference" in platform::cache_directory(). The directory is made on first write.
  explicit ReferenceCache(std::filesystem::path directory = {});

  // `key` is a platform::ContentHash::hex(). It must cover everything that the image depends on, including
  // the version of its algorithm.
  std::optional<VisibilityImage> find(const std::string& key) const;
  // Returns false when the file cannot be written (full disk, permissions); nothing partial is left.
  bool store(const std::string& key, const VisibilityImage& image) const;

  std::filesystem::path image_file(const std::string& key) const;

 private:
  platform::CacheStore store_;
};

}  // namespace penumbra::reference
