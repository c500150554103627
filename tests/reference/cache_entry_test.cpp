#include "reference/cache_entry.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "reference/scratch_folder.h"

namespace penumbra::reference {
namespace {

const std::string entry_key = "0123456789abcdef";

TEST(CacheEntry, GivesBackWhatWasAppended) {
  const ScratchFolder folder;
  CacheEntryWriter writer("title 1\n", entry_key);
  writer.append(std::int32_t{7});
  writer.append(std::span<const char>("rows", 4));
  writer.write(folder.path() / "entry");
  auto entry = CacheEntryReader::open(folder.path() / "entry", "title 1\n", entry_key);
  ASSERT_TRUE(entry.has_value());
  EXPECT_EQ(entry->take<std::int32_t>(), 7);
  EXPECT_EQ(entry->take<char>(4), (std::vector<char>{'r', 'o', 'w', 's'}));
  EXPECT_TRUE(entry->exhausted());
}

// Copying none of the elements of no payload is undefined where the pointers are null: a sanitizer sees it.
TEST(CacheEntry, NoElementsAreTakenOfNoPayload) {
  const ScratchFolder folder;
  CacheEntryWriter("title 1\n", entry_key).write(folder.path() / "entry");
  auto entry = CacheEntryReader::open(folder.path() / "entry", "title 1\n", entry_key);
  ASSERT_TRUE(entry.has_value());
  EXPECT_TRUE(entry->take<float>(0).empty());
  EXPECT_TRUE(entry->exhausted());
  EXPECT_TRUE(entry->take<float>(1).empty());
  EXPECT_FALSE(entry->exhausted());
}

}  // namespace
}  // namespace penumbra::reference
