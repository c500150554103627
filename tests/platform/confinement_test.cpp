// Workers of this test program try what a worker may not do. They try as root, too: nothing here is refused
// for want of permissions of a user.
#include "platform/confinement.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "platform/forbidden_attempts.h"
#include "platform/test_worker.h"
#include "platform/worker_pool.h"

namespace penumbra::platform {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

class Confinement : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    std::ofstream(file_) << "content";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string tried(const std::string& what) const {
    const WorkerOutcome outcome = ask_worker({{worker_mode}, 1, {}}, "try " + what);
    EXPECT_EQ(outcome.failure, "");
    return outcome.answer;
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("penumbra-confined-" + std::to_string(::getpid()));
  std::filesystem::path file_ = folder_ / "file";
};

TEST_F(Confinement, LeavesNoNetwork) {
  for (const char* what : {"a socket", "a socket of this machine", "to connect", "to send"})
    EXPECT_EQ(tried(what), "EPERM") << what;
}

TEST_F(Confinement, LeavesNoOtherProcess) {
  for (const char* what :
       {"another program", "a program in memory", "to fork", "to vfork", "to trace", "to read its parent",
        "to signal its parent", "another priority", "to change its parent's limits"})
    EXPECT_EQ(tried(what), "EPERM") << what;
}

TEST_F(Confinement, LeavesNoFileToBeChanged) {
  for (const char* what :
       {"to create", "to create for reading", "to create as before", "to create by structure"})
    EXPECT_EQ(tried(std::string(what) + ": " + (folder_ / "new").string()), "EPERM") << what;
  for (const char* what : {"to write", "to append", "to cut", "to truncate", "to remove", "to rename",
                           "to link", "a folder", "to change the mode"})
    EXPECT_EQ(tried(std::string(what) + ": " + file_.string()), "EPERM") << what;
  EXPECT_EQ(tried("to create nameless: " + folder_.string()), "EPERM");
  EXPECT_EQ(tried("io_uring"), "EPERM") << "it opens files past a filter";
  std::ostringstream content;
  content << std::ifstream(file_).rdbuf();
  EXPECT_EQ(content.str(), "content");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(Confinement, LeavesWhatReadingNeeds) {
  EXPECT_EQ(tried("to read: " + file_.string()), "done");
  EXPECT_EQ(tried("a thread"), "done");
  EXPECT_EQ(tried("private memory"), "done");
}

// The memory would be in no number that the parent reads, once it is unmapped.
TEST_F(Confinement, LeavesNoSharedMemory) {
  for (const char* what : {"a file in memory", "shared memory", "shared memory, validated", "a segment"})
    EXPECT_EQ(tried(what), "EPERM") << what;
}

TEST_F(Confinement, LeavesTheParentUnread) {
  for (const char* file : {"mem", "environ", "maps", "auxv"})
    EXPECT_THAT(tried(std::string("to read of its parent: ") + file), AnyOf("EPERM", "EACCES")) << file;
}

TEST_F(Confinement, IsForGood) {
  EXPECT_EQ(tried("own status: NoNewPrivs"), "1");
  EXPECT_EQ(tried("own status: Seccomp"), "2");
}

TEST_F(Confinement, ClosesWhatTheParentHasOpen) {
  const int descriptor = ::open(file_.c_str(), O_RDWR);  // the file is opened without O_CLOEXEC
  EXPECT_THAT(tried("descriptors"), Not(HasSubstr(file_.string())));
  ::close(descriptor);
}

TEST_F(Confinement, HidesTheParentsEnvironment) {
  ::setenv("A_SERVICE_TOKEN", "secret", 1);
  ::setenv("MESA_NO_ERROR", "1", 1);
  const std::string names = tried("environment");
  ::unsetenv("A_SERVICE_TOKEN");
  ::unsetenv("MESA_NO_ERROR");
  EXPECT_THAT(names, Not(HasSubstr("A_SERVICE_TOKEN")));
  EXPECT_THAT(names, HasSubstr("MESA_NO_ERROR")) << "its driver reads that";
}

// The parent is changed only while it has workers: a core file of the program itself is its user's.
TEST_F(Confinement, LeavesTheParentAsItWas) {
  EXPECT_EQ(::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0), 1);
  tried("private memory");
  EXPECT_EQ(::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0), 1);
}

TEST_F(Confinement, CanBeLeftWithoutTheFilter) {
  ::setenv("PENUMBRA_UNFILTERED_WORKERS", "1", 1);
  EXPECT_EQ(tried("a socket"), "done");
  EXPECT_EQ(tried("own status: NoNewPrivs"), "1");
  EXPECT_EQ(tried("a small file"), "done");
  EXPECT_EQ(tried("a large file"), "EFBIG");
  for (const char* what :
       {"to read its parent", "to read of its parent: mem", "to read of its parent: environ"})
    EXPECT_THAT(tried(what), AnyOf("EPERM", "EACCES")) << what;
  ::unsetenv("PENUMBRA_UNFILTERED_WORKERS");
}

}  // namespace
}  // namespace penumbra::platform
