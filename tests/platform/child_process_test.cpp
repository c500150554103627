#include "platform/child_process.h"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "input/input_error.h"
#include "platform/process_end.h"

namespace penumbra::platform {
namespace {

using testing::HasSubstr;

ChildCommand shell(const std::string& script) {
  return {"sh", {"-c", script}, {}};
}

TEST(ChildProcess, PassesArgumentsAsTheyAre) {
  const std::string evil = "a b\"'$(touch x)`id`;*\n";
  const ChildResult result = run_child({"printf", {"%s|%s", evil, ""}, {}});
  EXPECT_TRUE(result.succeeded());
  EXPECT_EQ(result.output, evil + "|");
}

TEST(ChildProcess, KeepsOutputErrorsAndExitCodeApart) {
  const ChildResult result = run_child(shell("echo out; echo err >&2; exit 3"));
  EXPECT_EQ(result.output, "out\n");
  EXPECT_EQ(result.errors, "err\n");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_FALSE(result.succeeded());
}

TEST(ChildProcess, SeesOurEnvironmentWithWhatIsAddedAndReplaced) {
  ::setenv("PENUMBRA_TEST_KEPT", "kept", 1);
  ::setenv("PENUMBRA_TEST_REPLACED", "old", 1);
  ChildCommand command{"env", {}, {}};  // no shell stands between, which would tidy up
  command.environment = {{"PENUMBRA_TEST_ADDED", "a b=c"}, {"PENUMBRA_TEST_REPLACED", "new"}};
  const std::string seen = "\n" + run_child(command).output;
  EXPECT_THAT(seen, HasSubstr("\nPENUMBRA_TEST_KEPT=kept\n"));
  EXPECT_THAT(seen, HasSubstr("\nPENUMBRA_TEST_ADDED=a b=c\n"));
  EXPECT_THAT(seen, HasSubstr("\nPENUMBRA_TEST_REPLACED=new\n"));
  EXPECT_THAT(seen, testing::Not(HasSubstr("PENUMBRA_TEST_REPLACED=old")));
  EXPECT_EQ(std::getenv("PENUMBRA_TEST_ADDED"), nullptr);
  EXPECT_STREQ(std::getenv("PENUMBRA_TEST_REPLACED"), "old");
}

TEST(ChildProcess, ALotOfTextGoesThroughBothWays) {
  ChildCommand command{"cat", {}, std::string(std::size_t{4} << 20, 'x') + "end"};
  EXPECT_EQ(run_child(command).output, command.input);
}

TEST(ChildProcess, AChildThatReadsNothingIsNoProblem) {
  ChildCommand command = shell("exit 0");
  command.input = std::string(std::size_t{1} << 20, 'x');
  EXPECT_TRUE(run_child(command).succeeded());
}

TEST(ChildProcess, TheTimeoutEndsItAndWhatItStarted) {
  // The child does not listen to a polite request, and neither does its own child.
  ChildCommand command = shell("trap '' TERM; sleep 3000 & echo $!; wait");
  command.timeout = std::chrono::milliseconds(200);
  ChildResult result = run_child(command);
  while (result.output.empty()) {  // on a busy machine it had not even begun
    command.timeout *= 2;
    result = run_child(command);
  }
  EXPECT_TRUE(result.timed_out);
  EXPECT_FALSE(result.succeeded());
  const int grandchild = std::atoi(result.output.c_str());
  ASSERT_GT(grandchild, 0);
  wait_for_the_end_of(grandchild);
}

TEST(ChildProcess, AGrandchildLeftBehindDoesNotKeepUsWaiting) {
  const ChildResult result = run_child(shell("sleep 3000 & echo $!"));
  EXPECT_TRUE(result.succeeded());
  ASSERT_GT(std::atoi(result.output.c_str()), 0);
  ::kill(std::atoi(result.output.c_str()), SIGKILL);
}

TEST(ChildProcess, EndlessOutputIsCutOff) {
  ChildCommand command = shell("while :; do echo and on; done");
  command.output_limit = 100'000;
  const ChildResult result = run_child(command);
  EXPECT_TRUE(result.overflowed);
  EXPECT_FALSE(result.timed_out);
  EXPECT_FALSE(result.succeeded());
}

TEST(ChildProcess, ASignalIsAnExitCodeOfItsOwn) {
  EXPECT_EQ(run_child(shell("kill -9 $$")).exit_code, 128 + SIGKILL);
}

TEST(ChildProcess, AMissingProgramIsTheEnvironmentsFault) {
  std::string message;
  try {
    run_child({"no-such-program-anywhere", {}, {}});
  } catch (const EnvironmentError& error) {
    message = error.what();
  }
  EXPECT_THAT(message, HasSubstr("'no-such-program-anywhere' cannot be started"));
}

TEST(FindProgram, LooksAlongThePath) {
  ASSERT_TRUE(find_program("sh").has_value());
  EXPECT_EQ(find_program("sh")->filename(), "sh");
  EXPECT_FALSE(find_program("no-such-program-anywhere").has_value());
}

}  // namespace
}  // namespace penumbra::platform
