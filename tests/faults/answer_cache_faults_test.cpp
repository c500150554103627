// The cache of validate's answers when memory or the disk fails: an entry is the old one, the new one, or
// absent.
#include "faults/every_fault.h"
#include "reference/scratch_folder.h"
#include "validation/answer_cache.h"

namespace penumbra::faults {
namespace {

namespace fs = std::filesystem;
using reference::ScratchFolder;
using validation::AnswerCache;
using validation::EntryKind;

const std::string key = "0123456789abcdef0123456789abcdef";
const std::string old_answer(3000, 'o');
const std::string new_answer(20'000, 'n');  // more than a stream's buffer

std::optional<std::string> kept(const fs::path& folder) {
  AnswerCache cache(folder);
  const std::optional<std::string> answer = cache.find(EntryKind::compile, key);
  EXPECT_EQ(cache.damaged(), 0U);
  return answer;
}

TEST(AnswerCacheFaults, AnEntryIsOldOrNewWhole) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "cache";
  with_every_fault({[&] {
                      fs::remove_all(folder);
                      AnswerCache(folder).store(EntryKind::compile, key, old_answer);
                    },
                    [&] { AnswerCache(folder).store(EntryKind::compile, key, new_answer); },
                    [&](End end, bool failed) {
                      EXPECT_NE(end, End::refused);
                      const std::optional<std::string> answer = kept(folder);
                      ASSERT_TRUE(answer.has_value());
                      EXPECT_TRUE(*answer == new_answer || (failed && *answer == old_answer));
                    }});
}

TEST(AnswerCacheFaults, AFirstEntryIsWholeOrAbsent) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "cache";
  with_every_fault({[&] { fs::remove_all(folder); },
                    [&] { AnswerCache(folder).store(EntryKind::compile, key, new_answer); },
                    [&](End, bool failed) {
                      const std::optional<std::string> answer = kept(folder);
                      EXPECT_TRUE(answer == new_answer || (failed && !answer));
                    }});
}

TEST(AnswerCacheFaults, OneFaultLeavesNoHalfWrittenFile) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "cache";
  for (const Kind kind : {Kind::memory, Kind::full, Kind::broken})
    with_every_fault(kind, Extent::once,
                     {[&] {
                        fs::remove_all(folder);
                        AnswerCache(folder).store(EntryKind::compile, key, old_answer);
                      },
                      [&] { AnswerCache(folder).store(EntryKind::compile, key, new_answer); },
                      [&](End, bool) { EXPECT_EQ(files_in(folder), 1U); }});
}

TEST(AnswerCacheFaults, ReadingGivesTheAnswerOrNone) {
  const ScratchFolder scratch;
  AnswerCache cache(scratch.path() / "cache");
  cache.store(EntryKind::compile, key, new_answer);
  std::optional<std::string> answer;
  with_every_fault({[&] { answer.reset(); }, [&] { answer = cache.find(EntryKind::compile, key); },
                    [&](End, bool failed) {
                      EXPECT_TRUE(answer == new_answer || (failed && !answer));
                      EXPECT_EQ(AnswerCache(scratch.path() / "cache").find(EntryKind::compile, key),
                                new_answer);
                    }});
}

// Not without memory: GCC's directory iterators call std::terminate then (their advance() is noexcept).
TEST(AnswerCacheFaults, TrimmingRemovesOldEntriesAndNothingElse) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "cache", stranger = folder / "01" / "notes.txt";
  const Trial trial{[&] {
                      fs::remove_all(folder);
                      AnswerCache cache(folder);
                      for (const char* digits : {"0", "1", "2"})
                        cache.store(EntryKind::compile, std::string(digits) + key.substr(1), old_answer);
                      fs::create_directories(stranger.parent_path());
                      std::ofstream(stranger) << "mine";
                    },
                    [&] { validation::trim_cache(folder, 2 * old_answer.size()); },
                    [&](End, bool failed) {
                      EXPECT_EQ(content_of(stranger), "mine");
                      EXPECT_TRUE(failed || files_in(folder) == 2U);
                    }};
  for (const Extent extent : {Extent::once, Extent::from_there})
    for (const Kind kind : {Kind::full, Kind::broken}) with_every_fault(kind, extent, trial);
}

}  // namespace
}  // namespace penumbra::faults
