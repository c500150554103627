#include "validation/answer_cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "shaders/shader_files.h"

namespace penumbra::validation {
namespace {

namespace fs = std::filesystem;
using shaders::ShaderFiles;

const std::string key = "0123456789abcdef0123456789abcdef";
const std::string other_key = "ffff456789abcdef0123456789abcdef";

std::string read(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

void set_age(const fs::path& file, std::chrono::hours age) {
  fs::last_write_time(file, fs::file_time_type::clock::now() - age);
}

std::string key_number(int number) {
  const std::string digits = std::to_string(number);
  return std::string(32 - digits.size(), '0') + digits;
}

TEST(AnswerCache, GivesBackWhatItWasGivenByKindAndKey) {
  const ShaderFiles files;
  AnswerCache cache(files.path("cache"));
  cache.store(EntryKind::compile, key, "one");
  cache.store(EntryKind::emitted, key, "");
  EXPECT_EQ(cache.find(EntryKind::compile, key), "one");
  EXPECT_EQ(cache.find(EntryKind::emitted, key), "");
  EXPECT_EQ(cache.find(EntryKind::sources, key), std::nullopt);
  EXPECT_EQ(cache.find(EntryKind::compile, other_key), std::nullopt);
  cache.store(EntryKind::compile, key, "two");
  EXPECT_EQ(cache.find(EntryKind::compile, key), "two");
  EXPECT_EQ(cache.damaged(), 0U);
}

TEST(AnswerCache, WithoutAFolderKeepsNothing) {
  AnswerCache cache({});
  cache.store(EntryKind::compile, key, "one");
  EXPECT_EQ(cache.find(EntryKind::compile, key), std::nullopt);
}

TEST(AnswerCache, ATruncatedEntryIsFoundAndWrittenAgain) {
  const ShaderFiles files;
  AnswerCache cache(files.path("cache"));
  cache.store(EntryKind::compile, key, "the answer");
  const fs::path place = cache.file(EntryKind::compile, key);
  const std::string whole = read(place);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(place, whole.substr(0, length));
    EXPECT_EQ(cache.find(EntryKind::compile, key), std::nullopt) << length;
    EXPECT_EQ(cache.damaged(), length + 1);
  }
  cache.store(EntryKind::compile, key, "the answer");
  EXPECT_EQ(cache.find(EntryKind::compile, key), "the answer");
}

TEST(AnswerCache, OneWrongBitIsFound) {
  const ShaderFiles files;
  AnswerCache cache(files.path("cache"));
  cache.store(EntryKind::compile, key, "the answer");
  const fs::path place = cache.file(EntryKind::compile, key);
  const std::string whole = read(place);
  for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1U << (bit % 8)));
    write(place, damaged);
    EXPECT_EQ(cache.find(EntryKind::compile, key), std::nullopt) << bit;
  }
}

TEST(AnswerCache, AnEntryInAnothersPlaceIsNotTaken) {
  const ShaderFiles files;
  AnswerCache cache(files.path("cache"));
  cache.store(EntryKind::compile, key, "one");
  const fs::path place = cache.file(EntryKind::compile, other_key);
  fs::create_directories(place.parent_path());
  fs::copy_file(cache.file(EntryKind::compile, key), place);
  EXPECT_EQ(cache.find(EntryKind::compile, other_key), std::nullopt);
}

TEST(AnswerCache, AFolderThatCannotBeWrittenCostsOnlyTime) {
  const ShaderFiles files;
  AnswerCache cache(files.write("a-file", "x"));
  cache.store(EntryKind::compile, key, "one");
  EXPECT_EQ(cache.find(EntryKind::compile, key), std::nullopt);
  EXPECT_EQ(cache.bytes_written(), 0U);
}

class Trimming : public testing::Test {
 protected:
  Trimming() {
    for (int i = 0; i < 20; ++i) {
      cache_.store(EntryKind::compile, key_number(i), std::string(1000, 'x'));
      set_age(cache_.file(EntryKind::compile, key_number(i)), std::chrono::hours(100 - i));
    }
    size_ = fs::file_size(cache_.file(EntryKind::compile, key_number(0)));
  }

  bool has(int number) { return fs::exists(cache_.file(EntryKind::compile, key_number(number))); }

  ShaderFiles files_;
  AnswerCache cache_{files_.path("cache")};
  std::uint64_t size_ = 0;
};

TEST_F(Trimming, RemovesWhatWasUsedLongestAgo) {
  EXPECT_TRUE(cache_.find(EntryKind::compile, key_number(3)));  // used now
  EXPECT_EQ(trim_cache(files_.path("cache"), 10 * size_), 10 * size_);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(has(i), i == 3 || i > 10) << i;
}

TEST_F(Trimming, LeavesACacheThatFits) {
  EXPECT_EQ(trim_cache(files_.path("cache"), 20 * size_), 20 * size_);
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(has(i));
}

TEST_F(Trimming, TouchesNothingThatIsNotTheCaches) {
  const auto mine = files_.write("cache/00/notes.txt", "mine");
  const auto alike = files_.write("cache/" + key_number(1) + ".compile", "no cache folder");
  set_age(mine, std::chrono::hours(1000));
  set_age(alike, std::chrono::hours(1000));
  EXPECT_EQ(trim_cache(files_.path("cache"), 0), 0U);
  EXPECT_TRUE(fs::exists(mine));
  EXPECT_TRUE(fs::exists(alike));
}

TEST_F(Trimming, SweepsUpAfterTheDeadAndNotTheLiving) {
  const auto dead = files_.write("cache/00/.17-1.part", "half");
  const auto living = files_.write("cache/00/.18-1.part", "half");
  set_age(dead, std::chrono::hours(2));
  trim_cache(files_.path("cache"), 20 * size_);
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(living));
}

TEST_F(Trimming, AnEntryThatIsBeingReadIsReadToItsEnd) {
  std::atomic<bool> stop = false;
  std::thread trimmer([&] {
    while (!stop) trim_cache(files_.path("cache"), 0);
  });
  const std::string content(100'000, 'y');
  for (int i = 0; i < 300; ++i) {
    cache_.store(EntryKind::compile, key, content);
    const std::optional<std::string> found = cache_.find(EntryKind::compile, key);
    EXPECT_EQ(found.value_or(content), content);
  }
  stop = true;
  trimmer.join();
  EXPECT_EQ(cache_.damaged(), 0U);
}

// Who else writes to the folder may have put links there.
TEST(AnswerCache, WritesThroughNoLink) {
  const ShaderFiles files;
  const fs::path folder = files.path("cache");
  AnswerCache cache(folder);
  cache.store(EntryKind::compile, key, "one");
  const fs::path other = files.path("precious");
  write(other, "precious");
  set_age(other, std::chrono::hours(48));
  const fs::file_time_type time = fs::last_write_time(other);
  fs::create_symlink(other, folder / "trimmed");
  fs::remove(cache.file(EntryKind::emitted, key));
  fs::create_symlink(other, cache.file(EntryKind::emitted, key));
  cache.find(EntryKind::emitted, key);
  trim_cache_when_due(folder, 1 << 20, 1);
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder / "trimmed")));
  cache.store(EntryKind::emitted, key, "two");
  EXPECT_EQ(cache.find(EntryKind::emitted, key), "two");
  EXPECT_EQ(read(other), "precious");
  EXPECT_EQ(fs::last_write_time(other), time);
}

TEST(AnswerCache, IsTrimmedOnceADayOrAfterMuchWasWritten) {
  const ShaderFiles files;
  const fs::path folder = files.path("cache");
  AnswerCache cache(folder);
  const std::string content(1000, 'x');
  for (int i = 0; i < 8; ++i) cache.store(EntryKind::compile, key_number(i), content);
  const auto count = [&] {
    int found = 0;
    for (int i = 0; i < 8; ++i) found += fs::exists(cache.file(EntryKind::compile, key_number(i))) ? 1 : 0;
    return found;
  };
  trim_cache_when_due(folder, 2000, 0);
  EXPECT_EQ(count(), 8) << "nothing was written";
  trim_cache_when_due(folder, 100'000, 1);
  EXPECT_EQ(count(), 8);
  trim_cache_when_due(folder, 2000, 1);
  EXPECT_EQ(count(), 8) << "it was looked at today";
  trim_cache_when_due(folder, 2000, 1000);
  EXPECT_LT(count(), 3);
  for (int i = 0; i < 8; ++i) cache.store(EntryKind::compile, key_number(i), content);
  set_age(folder / "trimmed", std::chrono::hours(25));
  trim_cache_when_due(folder, 2000, 1);
  EXPECT_LT(count(), 3);
}

}  // namespace
}  // namespace penumbra::validation
