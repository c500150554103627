// Reads entries of the caches: files of any content, and whole entries of any payload.
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "platform/cache_store.h"
#include "reference/reference_cache.h"

namespace penumbra::fuzz {

void targets::cache_entries(std::string_view bytes) {
  static const ScratchFolder folder;
  static const std::string key = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";

  const platform::CacheStore answers(folder.path() / "answers");
  folder.write("answers/01/" + answers.file("compile", key).filename().string(), bytes);
  const std::size_t damaged = answers.damaged();
  const bool found = answers.find("compile", key).has_value();
  require(found || answers.damaged() == damaged + 1, "an entry is whole, or it is counted");

  const reference::ReferenceCache references(folder.path() / "references");
  folder.write("references/01/" + references.image_file(key).filename().string(), bytes);
  references.find(key);
  const platform::CacheStore whole(folder.path() / "references");
  require(whole.store("visibility", key, bytes) && whole.find("visibility", key) == bytes,
          "what is kept is found");
  if (const auto read = references.find(key)) {
    require(read->visibility.size() == read->valid.size(), "an image has both of each pixel");
  }
}

}  // namespace penumbra::fuzz
