// Kept answers survive when memory or the disk fails: an entry is the old one, the new one, or absent.
#include <array>

#include "faults/every_fault.h"
#include "platform/cache_store.h"
#include "reference/scratch_folder.h"

namespace penumbra::faults {
namespace {

namespace fs = std::filesystem;
using platform::CacheStore;
using reference::ScratchFolder;

constexpr std::array<std::string_view, 1> kinds{"compile"};
const std::string key = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";
const std::string old_answer(3000, 'o');
const std::string new_answer(20'000, 'n');  // more than a stream's buffer

std::optional<std::string> kept(const fs::path& folder) {
  CacheStore cache(folder);
  const std::optional<std::string> answer = cache.find("compile", key);
  EXPECT_EQ(cache.damaged(), 0U);
  return answer;
}

TEST(CacheStoreFaults, AnEntryIsOldOrNewWhole) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "cache";
  with_every_fault({[&] {
                      fs::remove_all(folder);
                      CacheStore(folder).store("compile", key, old_answer);
                    },
                    [&] { CacheStore(folder).store("compile", key, new_answer); },
                    [&](End end, bool failed) {
                      EXPECT_NE(end, End::refused);
                      const std::optional<std::string> answer = kept(folder);
                      ASSERT_TRUE(answer.has_value());
                      EXPECT_TRUE(*answer == new_answer || (failed && *answer == old_answer));
                    }});
}

TEST(CacheStoreFaults, AFirstEntryIsWholeOrAbsent) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "cache";
  with_every_fault({[&] { fs::remove_all(folder); },
                    [&] { CacheStore(folder).store("compile", key, new_answer); },
                    [&](End, bool failed) {
                      const std::optional<std::string> answer = kept(folder);
                      EXPECT_TRUE(answer == new_answer || (failed && !answer));
                    }});
}

TEST(CacheStoreFaults, OneFaultLeavesNoHalfWrittenFile) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "cache";
  for (const Kind kind : {Kind::memory, Kind::full, Kind::broken})
    with_every_fault(kind, Extent::once,
                     {[&] {
                        fs::remove_all(folder);
                        CacheStore(folder).store("compile", key, old_answer);
                      },
                      [&] { CacheStore(folder).store("compile", key, new_answer); },
                      [&](End, bool) { EXPECT_EQ(files_in(folder), 1U); }});
}

TEST(CacheStoreFaults, ReadingGivesTheAnswerOrNone) {
  const ScratchFolder scratch;
  CacheStore cache(scratch.path() / "cache");
  cache.store("compile", key, new_answer);
  std::optional<std::string> answer;
  with_every_fault({[&] { answer.reset(); }, [&] { answer = cache.find("compile", key); },
                    [&](End, bool failed) {
                      EXPECT_TRUE(answer == new_answer || (failed && !answer));
                      EXPECT_EQ(CacheStore(scratch.path() / "cache").find("compile", key), new_answer);
                    }});
}

// The works run without faults of memory, because GCC's directory iterators call std::terminate then (their
// advance() is noexcept).
TEST(CacheStoreFaults, TrimmingRemovesOldEntriesAndNothingElse) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "cache", stranger = folder / "01" / "notes.txt";
  const Trial trial{[&] {
                      fs::remove_all(folder);
                      CacheStore cache(folder);
                      for (const char* digits : {"0", "1", "2"})
                        cache.store("compile", std::string(digits) + key.substr(1), old_answer);
                      fs::create_directories(stranger.parent_path());
                      std::ofstream(stranger) << "mine";
                    },
                    [&] { platform::trim_cache(folder, kinds, 2 * old_answer.size()); },
                    [&](End, bool failed) {
                      EXPECT_EQ(content_of(stranger), "mine");
                      EXPECT_TRUE(failed || files_in(folder) == 2U);
                    }};
  for (const Extent extent : {Extent::once, Extent::from_there})
    for (const Kind kind : {Kind::full, Kind::broken}) with_every_fault(kind, extent, trial);
}

}  // namespace
}  // namespace penumbra::faults
