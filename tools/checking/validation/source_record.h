// The files that a text consists of, so that the next run can tell without preprocessing that it is
// unchanged.
//
// The record is valid while every file that was read has the same contents, and every candidate that did not
// exist when an #include was resolved still does not exist: it would take precedence.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "shaders/compile.h"

namespace penumbra::validation {

// Returns the hash of the text as a compiler reads it: byte order mark and line endings make no difference.
std::string source_hash(std::string_view normalised_text);

// The current state of files, each read once: a run sees one state of every file. Not thread-safe.
class FilesNow {
 public:
  const std::optional<std::string>& hash(const std::string& file);  // nothing when it cannot be read
  bool is_absent(const std::string& file);

 private:
  std::unordered_map<std::string, std::optional<std::string>> hashes_;
  std::unordered_map<std::string, bool> absent_;
};

struct SourceRecord {
  std::string text_key;
  std::vector<std::pair<std::string, std::string>> files;  // every file that was read, with its hash
  std::vector<std::string> absent;

  bool is_true(FilesNow& now) const;
};

SourceRecord source_record(const shaders::PreprocessedSource& source, std::string text_key);

std::string encode(const SourceRecord& record);
std::optional<SourceRecord> decode_source_record(std::string_view bytes);

}  // namespace penumbra::validation
