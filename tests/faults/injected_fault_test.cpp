// The calls that are made to fail are those that the C and C++ libraries really make: a name that they stop
// using would go unnoticed otherwise.
#include "faults/every_fault.h"
#include "platform/atomic_file.h"
#include "reference/scratch_folder.h"

namespace penumbra::faults {
namespace {

namespace fs = std::filesystem;
using reference::ScratchFolder;

std::size_t failures(Kind kind, const std::function<void()>& work) {
  return with_every_fault(kind, Extent::once, {[] {}, work, [](End, bool) {}});
}

TEST(InjectedFaults, OneForEachAllocation) {
  const auto allocate = [] {
    const std::string text(1000, 'a');
    const std::vector<int> numbers(1000, static_cast<int>(text.size()));
    const std::vector<std::string> copies(2, text);
  };
  EXPECT_EQ(failures(Kind::memory, allocate), 5U);  // text, numbers, copies and their characters
}

TEST(InjectedFaults, OneForEachStepOfAWrittenFile) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "file";
  const auto write = [&] { platform::write_file_atomically(file, std::string_view("text")); };
  EXPECT_EQ(failures(Kind::full, write), 6U);    // fopen, fwrite, fflush, fsync, fclose, rename
  EXPECT_GT(failures(Kind::broken, write), 6U);  // the calls above and stat
}

TEST(InjectedFaults, OneForEachStepOfAStream) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "file";
  EXPECT_EQ(failures(Kind::full, [&] { std::ofstream(file) << "text"; }), 3U);  // fopen, write, fclose
  const auto read = [&] {
    std::ifstream stream(file);
    stream.seekg(0, std::ios::end);
    stream.seekg(0);
    std::string text;
    stream >> text;
  };
  EXPECT_GE(failures(Kind::broken, read), 5U);  // fopen, lseek64 twice, read, fclose
}

TEST(InjectedFaults, OneForEachStepOfAFolder) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "folder";
  const auto work = [&] {
    std::error_code error;
    fs::create_directory(folder, error);
    (void)fs::symlink_status(folder, error);
    for (fs::directory_iterator it(scratch.path(), error), end; it != end; it.increment(error)) {
    }
    fs::remove(folder, error);
  };
  EXPECT_GE(failures(Kind::broken, work), 5U);  // mkdir, lstat, fdopendir, readdir, remove
}

}  // namespace
}  // namespace penumbra::faults
