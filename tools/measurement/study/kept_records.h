// Finished records of a study with their pictures, kept until the study is finished, so that an interrupted
// study continues where it stopped.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "platform/cache_store.h"
#include "study/report.h"
#include "study/results.h"

namespace penumbra::study {

inline constexpr const char* kept_record_kind = "record";  // the kind of the store's entries

struct KeptRecord {
  MeasuredFrame frame;  // the frame of the record's scene and light
  Record record;
  PictureRow pictures;
  std::vector<std::string> unset_uniforms;
};

// A record that cannot be written, or not read again, is measured again.
class KeptRecords {
 public:
  // An empty folder means reference::ReferenceCache's own.
  explicit KeptRecords(const std::filesystem::path& folder);

  // `key` is the hash of everything that the record and its pictures depend on.
  std::optional<KeptRecord> find(const std::string& key);
  void store(const std::string& key, const KeptRecord& kept);

  // Returns whether every record that was given to store() is kept.
  bool complete() const { return complete_; }

  // Removes those that were found or stored by this object.
  void drop();

 private:
  platform::CacheStore store_;
  std::set<std::string> keys_;
  bool complete_ = true;
};

}  // namespace penumbra::study
