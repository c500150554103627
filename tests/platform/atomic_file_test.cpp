#include "platform/atomic_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "input/input_error_matcher.h"

namespace penumbra::platform {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class AtomicFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        (std::string("penumbra-atomic-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static std::string read(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()));
  }

  std::filesystem::path folder_;
};

TEST_F(AtomicFile, ReplacesTheOldContentAndLeavesNothingElse) {
  write_file_atomically(folder_ / "f", std::string_view("old"));
  write_file_atomically(folder_ / "f", std::string_view("new\0bytes", 9));
  EXPECT_EQ(read(folder_ / "f"), std::string("new\0bytes", 9));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFile, DoesNotWaitForAReaderOfAPipe) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  expect_input_error([&] { write_file_atomically(folder_ / "pipe", std::string_view("text")); },
                     HasSubstr("it is a pipe that no program reads"));
}

TEST_F(AtomicFile, RefusesAFolderAndAMissingParentByName) {
  std::filesystem::create_directories(folder_ / "d");
  expect_input_error([&] { write_file_atomically(folder_ / "d", std::string_view("x")); }, HasSubstr("/d: "));
  expect_input_error([&] { write_file_atomically(folder_ / "no" / "f", std::string_view("x")); },
                     HasSubstr("No such file or directory"));
  EXPECT_EQ(entries(), 1u);
}

// Anybody who can write into the folder could know a name made of the process's number beforehand.
TEST_F(AtomicFile, WhatLiesUnderTheNameOfATemporaryFileIsNotTouched) {
  std::ofstream(folder_ / "victim") << "precious";
  const std::string process = std::to_string(::getpid());
  std::filesystem::create_symlink("victim", folder_ / (".f." + process + ".part"));
  ASSERT_EQ(::mkfifo((folder_ / (".g." + process + ".part")).c_str(), 0600), 0);
  check_file_can_be_written(folder_ / "f");
  for (const char* name : {"f", "g"}) write_file_atomically(folder_ / name, std::string_view("new"));
  EXPECT_EQ(read(folder_ / "victim"), "precious");
  EXPECT_EQ(read(folder_ / "f"), "new");
  EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "g"));
  EXPECT_EQ(entries(), 5u) << "victim, f, g, the link and the pipe";
}

// A rename would put a file in the device's place: -o /dev/null must leave the device there.
TEST_F(AtomicFile, WhatIsNoFileIsWrittenToAndStays) {
  const std::filesystem::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string seen;
  std::thread reader([&] { seen = read(pipe); });
  write_file_atomically(pipe, std::string_view("through"));
  reader.join();
  EXPECT_EQ(seen, "through");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_EQ(entries(), 1u);
}

// The second file's name is a folder when the file is to be replaced, so that renaming it fails.
TEST_F(AtomicFile, OfFilesThatBelongTogetherAllAreReplacedOrNone) {
  write_files_atomically({{folder_ / "picture", "old"}, {folder_ / "names", "it"}});
  EXPECT_EQ(read(folder_ / "picture") + read(folder_ / "names"), "oldit");
  write_files_atomically(
      {{folder_ / "picture", "new"}, {folder_ / "names", "them"}, {folder_ / "third", "3"}});
  EXPECT_EQ(read(folder_ / "picture") + read(folder_ / "names") + read(folder_ / "third"), "newthem3");
  EXPECT_EQ(entries(), 3u);

  expect_input_error(
      [&] {
        write_files_atomically({{folder_ / "picture", "newer"}, {folder_ / "no" / "names", "x"}});
      },
      AllOf(HasSubstr("no/names: cannot be written"), HasSubstr("the file was not changed")));
  EXPECT_EQ(read(folder_ / "picture"), "new");
  EXPECT_EQ(entries(), 3u);
}

// In a folder that has become the current one, a checkout's links are known by their place.
class CheckedOut : public AtomicFile {
 protected:
  void SetUp() override {
    AtomicFile::SetUp();
    std::filesystem::create_directories(folder_ / "checkout" / "plain");
    std::filesystem::create_directories(folder_ / "elsewhere" / "inner");
    std::filesystem::create_directory_symlink(folder_ / "elsewhere", folder_ / "checkout" / "link");
    std::ofstream(folder_ / "elsewhere" / "f") << "another's";
  }
  void TearDown() override {
    std::filesystem::current_path(before_);
    AtomicFile::TearDown();
  }

  void expect_refused(const std::filesystem::path& file) const {
    const auto refusal =
        AllOf(HasSubstr("link' is a link, which is not followed"), HasSubstr("the file was not changed"));
    expect_input_error([&] { write_file_atomically(file, std::string_view("x")); }, refusal);
    expect_input_error([&] { check_file_can_be_written(file); }, refusal);
    expect_input_error([&] { check_folder_can_be_written(file.parent_path(), "named"); }, refusal);
    EXPECT_EQ(read(folder_ / "elsewhere" / "f"), "another's");
  }

  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(CheckedOut, ItsLinkedFoldersAreNotFollowed) {
  std::filesystem::current_path(folder_ / "checkout");
  for (const char* file : {"link/f", "./link/inner/new", "plain/../link/f", "link/../f", "link/inner/../f"})
    expect_refused(file);
  expect_refused(folder_ / "checkout" / "link" / "f");
  write_file_atomically("plain/f", std::string_view("x"));
  EXPECT_EQ(read(folder_ / "checkout" / "plain" / "f"), "x");
}

TEST_F(CheckedOut, ARepositoryIsOneFromElsewhereToo) {
  std::filesystem::create_directories(folder_ / "checkout" / ".git");
  std::filesystem::create_directories(folder_ / "elsewhere" / ".git");
  expect_refused(folder_ / "checkout" / "link" / "f");
  std::filesystem::current_path(folder_ / "checkout" / "plain");
  expect_refused("../link/f");
}

TEST_F(CheckedOut, ItsLinkToADeviceIsReplacedAndNotWrittenTo) {
  std::filesystem::create_symlink("/dev/full", folder_ / "checkout" / "report");
  std::filesystem::current_path(folder_ / "checkout");
  write_file_atomically("report", std::string_view("x"));
  EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status("report")));
}

// The folder of temporary files is a link on some systems, and a user's results may lie behind one.
TEST_F(CheckedOut, LinksThatAreTheUsersAreFollowed) {
  write_file_atomically(folder_ / "checkout" / "link" / "f", std::string_view("followed"));
  EXPECT_EQ(read(folder_ / "elsewhere" / "f"), "followed");
}

// Readers running all the while see one whole content or the other, never a mixture.
TEST_F(AtomicFile, AReaderNeverSeesHalfAFile) {
  const std::string a(1 << 20, 'a');
  const std::string b(1 << 20, 'b');
  write_file_atomically(folder_ / "f", a);
  std::thread writer([&] {
    for (int i = 0; i < 20; ++i) write_file_atomically(folder_ / "f", i % 2 == 0 ? b : a);
  });
  int torn = 0;
  for (int i = 0; i < 200; ++i) {
    const std::string seen = read(folder_ / "f");
    if (seen != a && seen != b) ++torn;
  }
  writer.join();
  EXPECT_EQ(torn, 0);
}

TEST_F(AtomicFile, OfFilesThatBelongTogetherNoneMayBeAPipe) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  for (const auto& order : {std::pair("pipe", "new"), std::pair("new", "pipe")}) {
    expect_input_error(
        [&] {
          write_files_atomically({{folder_ / order.first, "a"}, {folder_ / order.second, "b"}});
        },
        HasSubstr("is a device or a pipe, and one of several files that belong together"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "new"));
  }
}

}  // namespace
}  // namespace penumbra::platform
