#include "platform/cache_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "reference/scratch_folder.h"

namespace penumbra::platform {
namespace {

namespace fs = std::filesystem;
using reference::ScratchFolder;

constexpr std::array<std::string_view, 2> kinds{"compile", "emitted"};
const std::string key = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";
const std::string other_key = "ffff456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";

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
  return std::string(64 - digits.size(), '0') + digits;
}

TEST(CacheStore, GivesBackWhatItWasGivenByKindAndKey) {
  const ScratchFolder files;
  CacheStore cache(files.path() / "cache");
  cache.store("compile", key, "one");
  cache.store("emitted", key, "");
  EXPECT_EQ(cache.find("compile", key), "one");
  EXPECT_EQ(cache.find("emitted", key), "");
  EXPECT_EQ(cache.find("sources", key), std::nullopt);
  EXPECT_EQ(cache.find("compile", other_key), std::nullopt);
  cache.store("compile", key, "two");
  EXPECT_EQ(cache.find("compile", key), "two");
  EXPECT_EQ(cache.damaged(), 0U);
}

TEST(CacheStore, WithoutAFolderKeepsNothing) {
  CacheStore cache({});
  cache.store("compile", key, "one");
  EXPECT_EQ(cache.find("compile", key), std::nullopt);
}

TEST(CacheStore, ATruncatedEntryIsFoundAndWrittenAgain) {
  const ScratchFolder files;
  CacheStore cache(files.path() / "cache");
  cache.store("compile", key, "the answer");
  const fs::path place = cache.file("compile", key);
  const std::string whole = read(place);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(place, whole.substr(0, length));
    EXPECT_EQ(cache.find("compile", key), std::nullopt) << length;
    EXPECT_EQ(cache.damaged(), length + 1);
  }
  cache.store("compile", key, "the answer");
  EXPECT_EQ(cache.find("compile", key), "the answer");
}

TEST(CacheStore, AnEntryThatIsTooLargeIsNeitherWrittenNorRead) {
  const ScratchFolder files;
  CacheStore cache(files.path() / "cache");
  EXPECT_FALSE(cache.store("compile", key, std::string(std::size_t{1} << 28U, ' ')));
  EXPECT_FALSE(fs::exists(cache.file("compile", key)));
  cache.store("compile", key, "the answer");
  fs::resize_file(cache.file("compile", key), std::uintmax_t{100} << 30U);  // the file takes no space
  EXPECT_EQ(cache.find("compile", key), std::nullopt);
  cache.store("compile", key, "the answer");
  EXPECT_EQ(cache.find("compile", key), "the answer");
}

TEST(CacheStore, OneWrongBitIsFound) {
  const ScratchFolder files;
  CacheStore cache(files.path() / "cache");
  cache.store("compile", key, "the answer");
  const fs::path place = cache.file("compile", key);
  const std::string whole = read(place);
  for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1U << (bit % 8)));
    write(place, damaged);
    EXPECT_EQ(cache.find("compile", key), std::nullopt) << bit;
  }
}

TEST(CacheStore, AnEntryInAnothersPlaceIsNotTaken) {
  const ScratchFolder files;
  CacheStore cache(files.path() / "cache");
  cache.store("compile", key, "one");
  const fs::path place = cache.file("compile", other_key);
  fs::create_directories(place.parent_path());
  fs::copy_file(cache.file("compile", key), place);
  EXPECT_EQ(cache.find("compile", other_key), std::nullopt);
}

TEST(CacheStore, AnEntryOfAnotherKindIsNotTaken) {
  const ScratchFolder files;
  const CacheStore cache(files.path());
  EXPECT_TRUE(cache.store("compile", key, "one"));
  fs::copy_file(cache.file("compile", key), cache.file("emitted", key));
  EXPECT_EQ(cache.find("emitted", key), std::nullopt);
  EXPECT_EQ(cache.damaged(), 1U);
  cache.drop("emitted", key);
  EXPECT_FALSE(fs::exists(cache.file("emitted", key)));
  EXPECT_EQ(cache.find("compile", key), "one");
}

TEST(CacheStore, AFolderThatCannotBeWrittenCostsOnlyTime) {
  const ScratchFolder files;
  write(files.path() / "a-file", "x");
  CacheStore cache(files.path() / "a-file");
  cache.store("compile", key, "one");
  EXPECT_EQ(cache.find("compile", key), std::nullopt);
  EXPECT_EQ(cache.bytes_written(), 0U);
}

class Trimming : public testing::Test {
 protected:
  Trimming() {
    for (int i = 0; i < 20; ++i) {
      cache_.store("compile", key_number(i), std::string(1000, 'x'));
      set_age(cache_.file("compile", key_number(i)), std::chrono::hours(100 - i));
    }
    size_ = fs::file_size(cache_.file("compile", key_number(0)));
  }

  bool has(int number) { return fs::exists(cache_.file("compile", key_number(number))); }

  ScratchFolder files_;
  CacheStore cache_{files_.path() / "cache"};
  std::uint64_t size_ = 0;
};

TEST_F(Trimming, RemovesWhatWasUsedLongestAgo) {
  EXPECT_TRUE(cache_.find("compile", key_number(3)));  // used now
  EXPECT_EQ(trim_cache(files_.path() / "cache", kinds, 10 * size_), 10 * size_);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(has(i), i == 3 || i > 10) << i;
}

TEST_F(Trimming, LeavesACacheThatFits) {
  EXPECT_EQ(trim_cache(files_.path() / "cache", kinds, 20 * size_), 20 * size_);
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(has(i));
}

TEST_F(Trimming, TouchesNothingThatIsNotTheCaches) {
  const fs::path mine = files_.path() / "cache/00/notes.txt";
  write(mine, "mine");
  const fs::path alike = files_.path() / ("cache/" + key_number(1) + ".compile");
  write(alike, "no cache folder");
  const fs::path other_kind = cache_.file("rows", key_number(1));
  write(other_kind, "of who keeps other answers here");
  set_age(mine, std::chrono::hours(1000));
  set_age(other_kind, std::chrono::hours(1000));
  set_age(alike, std::chrono::hours(1000));
  EXPECT_EQ(trim_cache(files_.path() / "cache", kinds, 0), 0U);
  EXPECT_TRUE(fs::exists(mine));
  EXPECT_TRUE(fs::exists(other_kind));
  EXPECT_TRUE(fs::exists(alike));
}

TEST_F(Trimming, SweepsUpAfterTheDeadAndNotTheLiving) {
  const fs::path dead = files_.path() / "cache/00/.17-1.part";
  write(dead, "half");
  const fs::path living = files_.path() / "cache/00/.18-1.part";
  write(living, "half");
  set_age(dead, std::chrono::hours(2));
  trim_cache(files_.path() / "cache", kinds, 20 * size_);
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(living));
}

TEST_F(Trimming, AnEntryThatIsBeingReadIsReadToItsEnd) {
  std::atomic<bool> stop = false;
  std::thread trimmer([&] {
    while (!stop) trim_cache(files_.path() / "cache", kinds, 0);
  });
  const std::string content(100'000, 'y');
  for (int i = 0; i < 300; ++i) {
    cache_.store("compile", key, content);
    const std::optional<std::string> found = cache_.find("compile", key);
    EXPECT_EQ(found.value_or(content), content);
  }
  stop = true;
  trimmer.join();
  EXPECT_EQ(cache_.damaged(), 0U);
}

// Somebody else who writes to the folder may have put links there.
TEST(CacheStore, WritesThroughNoLink) {
  const ScratchFolder files;
  const fs::path folder = files.path() / "cache";
  CacheStore cache(folder);
  cache.store("compile", key, "one");
  const fs::path other = files.path() / "precious";
  write(other, "precious");
  set_age(other, std::chrono::hours(48));
  const fs::file_time_type time = fs::last_write_time(other);
  fs::create_symlink(other, folder / "trimmed");
  fs::remove(cache.file("emitted", key));
  fs::create_symlink(other, cache.file("emitted", key));
  cache.find("emitted", key);
  trim_cache_when_due(folder, kinds, 1 << 20, 1);
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder / "trimmed")));
  cache.store("emitted", key, "two");
  EXPECT_EQ(cache.find("emitted", key), "two");
  EXPECT_EQ(read(other), "precious");
  EXPECT_EQ(fs::last_write_time(other), time);
}

TEST(CacheStore, IsTrimmedOnceADayOrAfterMuchWasWritten) {
  const ScratchFolder files;
  const fs::path folder = files.path() / "cache";
  CacheStore cache(folder);
  const std::string content(1000, 'x');
  for (int i = 0; i < 8; ++i) cache.store("compile", key_number(i), content);
  const auto count = [&] {
    int found = 0;
    for (int i = 0; i < 8; ++i) found += fs::exists(cache.file("compile", key_number(i))) ? 1 : 0;
    return found;
  };
  trim_cache_when_due(folder, kinds, 2000, 0);
  EXPECT_EQ(count(), 8) << "nothing was written";
  trim_cache_when_due(folder, kinds, 100'000, 1);
  EXPECT_EQ(count(), 8);
  trim_cache_when_due(folder, kinds, 2000, 1);
  EXPECT_EQ(count(), 8) << "it was looked at today";
  trim_cache_when_due(folder, kinds, 2000, 1000);
  EXPECT_LT(count(), 3);
  for (int i = 0; i < 8; ++i) cache.store("compile", key_number(i), content);
  set_age(folder / "trimmed", std::chrono::hours(25));
  trim_cache_when_due(folder, kinds, 2000, 1);
  EXPECT_LT(count(), 3);
}

}  // namespace
}  // namespace penumbra::platform
