// Entries of the caches: files of any content, and whole entries of any payload.
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "reference/cache_entry.h"
#include "reference/reference_cache.h"
#include "validation/answer_cache.h"

namespace penumbra::fuzz {

void targets::cache_entries(std::string_view bytes) {
  static const ScratchFolder folder;
  static const std::string key = "0123456789abcdef0123456789abcdef";

  validation::AnswerCache answers(folder.path() / "answers");
  folder.write("answers/01/23456789abcdef0123456789abcdef.compile", bytes);
  const bool found = answers.find(validation::EntryKind::compile, key).has_value();
  require(found || answers.damaged() == 1, "an entry is whole, or it is counted");

  const reference::ReferenceCache references(folder.path() / "references");
  for (const std::filesystem::path& file : {references.image_file(key), references.beginning_file(key)}) {
    folder.write("references/" + file.filename().string(), bytes);
  }
  references.find(key);
  references.find_beginning(key);
  reference::CacheEntryWriter image("penumbra reference image 1\n", key),
      rows("penumbra reference rows 1\n", key);
  image.append(std::span<const char>(bytes.data(), bytes.size()));
  rows.append(std::span<const char>(bytes.data(), bytes.size()));
  image.write(references.image_file(key));
  rows.write(references.beginning_file(key));
  if (const auto read = references.find(key)) {
    require(read->visibility.size() == read->valid.size(), "an image has both of each pixel");
  }
  require(references.find_beginning(key).size() * sizeof(reference::HalfCounts) <= bytes.size(),
          "rows of the file");
}

}  // namespace penumbra::fuzz
