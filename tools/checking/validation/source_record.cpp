#include "validation/source_record.h"

#include <algorithm>
#include <system_error>

#include "hlsl/source_text.h"
#include "platform/byte_stream.h"
#include "platform/content_hash.h"

namespace penumbra::validation {

using platform::ByteReader;
using platform::ByteWriter;

namespace fs = std::filesystem;

std::string source_hash(std::string_view normalised_text) {
  return platform::ContentHash().update(normalised_text).hex();
}

const std::optional<std::string>& FilesNow::hash(const std::string& file) {
  const auto [place, first] = hashes_.try_emplace(file);
  if (first) {
    const hlsl::SourceRead read = hlsl::read_source(file);
    if (read.problem.empty()) place->second = source_hash(read.text);
  }
  return place->second;
}

bool FilesNow::is_absent(const std::string& file) {
  const auto [place, first] = absent_.try_emplace(file);
  if (first) {
    std::error_code ignored;
    place->second = !fs::exists(fs::symlink_status(file, ignored));
  }
  return place->second;
}

bool SourceRecord::is_true(FilesNow& now) const {
  return std::all_of(files.begin(), files.end(),
                     [&](const auto& file) { return now.hash(file.first) == file.second; }) &&
         std::all_of(absent.begin(), absent.end(),
                     [&](const std::string& file) { return now.is_absent(file); });
}

SourceRecord source_record(const shaders::PreprocessedSource& source, std::string text_key) {
  SourceRecord record{std::move(text_key), {}, {}};
  for (const fs::path& file : source.dependencies)
    record.files.emplace_back(file.string(), source_hash(source.sources.text(file.string())));
  for (const fs::path& file : source.absent) record.absent.push_back(file.string());
  return record;
}

std::string encode(const SourceRecord& record) {
  ByteWriter out;
  out.text(record.text_key);
  out.list(record.files, [&](const auto& file) {
    out.text(file.first);
    out.text(file.second);
  });
  out.list(record.absent, [&](const std::string& file) { out.text(file); });
  return out.take();
}

std::optional<SourceRecord> decode_source_record(std::string_view bytes) {
  ByteReader in(bytes);
  SourceRecord record;
  record.text_key = in.text();
  record.files = in.list<std::pair<std::string, std::string>>([&] {
    std::string file = in.text();
    return std::pair(std::move(file), in.text());
  });
  record.absent = in.list<std::string>([&] { return in.text(); });
  if (!in.exhausted()) return std::nullopt;
  return record;
}

}  // namespace penumbra::validation
