#include "input/text_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "input/input_error_matcher.h"
#include "input/located_json.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class TextFile : public testing::Test {
 protected:
  TextFile() { fs::create_directories(folder_); }
  ~TextFile() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  fs::path pipe() const {
    const fs::path file = folder_ / "pipe";
    EXPECT_EQ(::mkfifo(file.c_str(), 0600), 0);
    return file;
  }

  fs::path folder_ = fs::temp_directory_path() / ("penumbra-text-file-" + std::to_string(::getpid()));
};

TEST_F(TextFile, IsReadWhole) {
  const std::string text(200000, 'x');
  EXPECT_EQ(read_text_file(write("a", text + '\0' + "\r\n")), text + '\0' + "\r\n");
  EXPECT_EQ(read_found_text_file(write("b", "")), "");
}

TEST_F(TextFile, OneThatIsTooLongIsRefused) {
  EXPECT_EQ(read_text_file(write("a", "1234"), 4), "1234");
  expect_input_error([&] { read_text_file(folder_ / "a", 3); }, HasSubstr("a: has more than 3 bytes"));
  expect_input_error([&] { read_text_file("/dev/zero", 1000); }, HasSubstr("has more than 1000 bytes"));
}

TEST_F(TextFile, WhatIsFoundMustBeARegularFile) {
  expect_input_error([] { read_found_text_file("/dev/zero"); }, HasSubstr("is a device or a pipe"));
  expect_input_error([&] { LocatedJson::read_found(pipe()); }, HasSubstr("is a device or a pipe"));
  expect_input_error([&] { read_found_text_file(folder_); }, HasSubstr("is a folder"));
  expect_input_error([&] { read_found_text_file(folder_ / "none"); }, HasSubstr("cannot be opened"));
}

// Opening it would wait for somebody who writes.
TEST_F(TextFile, ANamedPipeIsRefused) {
  const fs::path named = pipe();
  expect_input_error([&] { read_text_file(named); }, HasSubstr("pipe: is a named pipe"));
  fs::create_symlink(named, folder_ / "link");
  expect_input_error([&] { read_text_file(folder_ / "link"); }, HasSubstr("link: is a named pipe"));
}

#ifdef __linux__
TEST_F(TextFile, AnOpenPipeIsRead) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], "text", 4), 4);
  ::close(ends[1]);
  EXPECT_EQ(read_text_file("/dev/fd/" + std::to_string(ends[0])), "text");
  ::close(ends[0]);
}

// Reading the first page of a process's memory gives EIO, as a broken disk does.
TEST_F(TextFile, OneThatCannotBeReadToItsEndIsAnError) {
  expect_input_error([] { read_text_file("/proc/self/mem"); }, HasSubstr("cannot be read"));
  std::ifstream memory("/proc/self/mem");
  EXPECT_EQ(rest_of(memory), std::nullopt);
}
#endif

}  // namespace
}  // namespace penumbra
