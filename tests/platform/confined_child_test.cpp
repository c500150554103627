// A confined child opens the files that it is given, no others, and no sockets to other machines.
#include "platform/confined_child.h"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "input/input_error.h"
#include "platform/terminal.h"

namespace penumbra::platform {
namespace {

namespace fs = std::filesystem;

bool kernel_has_landlock() {
#ifdef SYS_landlock_create_ruleset
  return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, 1) > 0;
#else
  return false;
#endif
}

class ConfinedChildTest : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(folder_ / "secret") << "secret text"; }
  void TearDown() override { fs::remove_all(folder_); }

  // All that the shell's command writes.
  std::string output_of(const std::string& shell, const std::vector<fs::path>& readable,
                        const std::vector<fs::path>& writable) const {
    ConfinedCommand command;
    command.program = "/bin/sh";
    command.arguments = {"-c", shell};
    command.environment = {{"FOLDER", folder_.string()}, {"PATH", "/usr/bin:/bin"}};
    command.directory = "/";
    command.readable = {"/usr", "/bin", "/lib", "/lib64", "/etc", "/dev"};
    command.readable.insert(command.readable.end(), readable.begin(), readable.end());
    command.writable = writable;
    ConfinedChild child(command);
    std::string text;
    for (char c; child.read(&c, 1);) text += c;
    return text;
  }

  fs::path folder_ = new_private_directory("penumbra-confined-test");
};

TEST_F(ConfinedChildTest, AnswersThroughItsPipesWithItsOwnEnvironmentAlone) {
  ConfinedCommand command;
  command.program = "/bin/sh";
  command.arguments = {"-c", "read line; echo $line $NAME $HOME"};
  command.environment = {{"NAME", "value"}};
  command.directory = "/";
  command.readable = {"/"};
  ConfinedChild child(command);
  EXPECT_TRUE(child.write("asked\n"));
  std::string answer(12, ' ');
  EXPECT_TRUE(child.read(answer.data(), answer.size()));
  EXPECT_EQ(answer, "asked value\n");
  char more = 0;
  EXPECT_FALSE(child.read(&more, 1));
}

TEST_F(ConfinedChildTest, IsGivenUpWhereItStaysSilent) {
  ConfinedCommand command;
  command.program = "/bin/sleep";
  command.arguments = {"1000"};
  command.directory = "/";
  command.readable = {"/"};
  command.patience = std::chrono::seconds(1);
  ConfinedChild child(command);
  char answer = 0;
  EXPECT_FALSE(child.read(&answer, 1));
  // The text is more than a pipe holds.
  EXPECT_FALSE(child.write(std::string(std::size_t{1} << 20, 'a')));
}

// Wine's server outlives the program that it serves, and holds its pipes.
TEST_F(ConfinedChildTest, HasEndedEvenIfWhatItStartedHoldsItsPipes) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(output_of("printf said; sleep 60 & exit", {}, {}), "said");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(50));
}

TEST_F(ConfinedChildTest, ReadsAndWritesWhatItIsGiven) {
  EXPECT_EQ(output_of("cat $FOLDER/secret", {folder_}, {}), "secret text");
  EXPECT_EQ(output_of("echo a > $FOLDER/new; cat $FOLDER/new", {}, {folder_}), "a\n");
}

TEST_F(ConfinedChildTest, ReadsAndWritesNothingElse) {
  if (!kernel_has_landlock()) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_EQ(output_of("cat $FOLDER/secret || echo refused", {}, {}), "refused\n");
  EXPECT_EQ(output_of("(echo a > $FOLDER/new) || echo refused", {folder_}, {}), "refused\n");
  EXPECT_EQ(output_of("rm $FOLDER/secret || echo refused", {folder_}, {}), "refused\n");
  EXPECT_TRUE(fs::exists(folder_ / "secret"));
}

#ifdef PENUMBRA_HAS_SECCOMP
TEST_F(ConfinedChildTest, OpensNoNetworkSocketsAndNoNamespaces) {
  EXPECT_EQ(
      output_of("perl -MSocket -e 'print socket(S, PF_INET, SOCK_STREAM, 0) ? q(open) : q(refused)'", {}, {}),
      "refused");
  EXPECT_EQ(
      output_of("perl -MSocket -e 'print socket(S, PF_UNIX, SOCK_STREAM, 0) ? q(open) : q(refused)'", {}, {}),
      "open");
  EXPECT_EQ(output_of("unshare -U true || echo refused", {}, {}), "refused\n");
}
#endif

TEST_F(ConfinedChildTest, AProgramThatIsNotThereEndsAtOnce) {
  ConfinedCommand command;
  command.program = "/nowhere/program";
  command.directory = "/";
  ConfinedChild child(command);
  char none = 0;
  EXPECT_FALSE(child.read(&none, 1));
}

}  // namespace
}  // namespace penumbra::platform
