// Which files a text was made of, so that the next run need not make it again to know that it is the same.
//
// The record is true while every file that was read holds what it held, and every place where an #include was
// looked for first is still empty: a file that appears there would be read instead.
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

// Of the text as a compiler reads it: byte order mark and line endings make no difference.
std::string source_hash(std::string_view normalised_text);

// What the disk holds, each file looked at once: a run sees one state of every file. Not for several threads.
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
