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

// Whoever can write into the folder could know a name made of the process's number beforehand.
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

// A rename would put a file in its place: -o /dev/null must leave the device there.
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

}  // namespace
}  // namespace penumbra::platform
