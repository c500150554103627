// Tests where FXC is searched, and what is said where it is not. The answer is kept, so each case is a
// process of its own.
#include <gtest/gtest.h>

#include <cstdlib>

#include "fxc/fxc.h"
#include "input/input_error.h"

namespace penumbra::fxc {
namespace {

// Prints what is missing with that value of PENUMBRA_FXC, in the child process of a death test.
[[noreturn]] void say_what_is_missing(const char* location) {
  ::setenv(location_variable, location, 1);
  try {
    require_fxc();
    std::fprintf(stderr, "found\n");
  } catch (const EnvironmentError& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  std::exit(0);
}

TEST(FindFxcDeathTest, OffAndWrongFilesAreSaid) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(say_what_is_missing("off"), testing::ExitedWithCode(0),
              "not at hand: it is turned off, by --fxc or PENUMBRA_FXC");
  EXPECT_EXIT(say_what_is_missing("/nowhere/d3dcompiler_47.dll"), testing::ExitedWithCode(0),
              "'/nowhere/d3dcompiler_47.dll' does not exist");
  EXPECT_EXIT(say_what_is_missing("/etc/passwd"), testing::ExitedWithCode(0),
              "'/etc/passwd' is no DLL of Windows");
}

}  // namespace
}  // namespace penumbra::fxc
