// Every subcommand that writes says before any work begins where output cannot go.
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class Output : public ProgramTest {
 protected:
  // The work itself would fail, too, in each of these commands, with another message; the output comes first.
  std::vector<std::vector<std::string>> commands_with_files() const {
    const std::string none = path("none").string();
    return {{"constants", "--config", none, "-o"}, {"tables", "-o"},      {"validate", none, "-o"},
            {"emit", "--single-file", none, "-o"}, {"merge", none, "-o"}, {"cost", "--from", none, "-o"}};
  }

  static void expect_refused(std::vector<std::string> command, const std::string& place,
                             const std::string& why) {
    command.push_back(place);
    expect_bad_input(command, HasSubstrs(place, why));
  }
};

TEST_F(Output, AFileNeedsAFolderThatIsThere) {
  for (const auto& command : commands_with_files())
    expect_refused(command, path("no/such.json").string(), "No such file or directory");
  EXPECT_THAT(listing(), IsEmpty());
}

TEST_F(Output, AFolderIsNoFile) {
  for (const auto& command : commands_with_files())
    expect_refused(command, path("").string(), "Is a directory");
  EXPECT_THAT(listing(), IsEmpty());
}

#ifdef __linux__
TEST_F(Output, AFolderWhereNothingCanBeWrittenIsNamedAsItWasGiven) {
  expect_refused({"validate", "none.hlsl", "--keep"}, "/proc/kept", "/proc/kept: cannot be written: ");
}
#endif

TEST_F(Output, AFolderMayBeNewButNotBelowAFile) {
  const std::string file = write("file", "text").string();
  for (const auto& command : std::vector<std::vector<std::string>>{{"measure", "--scene", "none", "-o"},
                                                                   {"render", "--scene", "none", "-o"},
                                                                   {"measure", "--scene", "none", "--cache"},
                                                                   {"render", "--scene", "none", "--cache"},
                                                                   {"validate", "none.hlsl", "--cache"},
                                                                   {"validate", "none.hlsl", "--keep"}}) {
    expect_refused(command, file, "is a file, not a folder");
    expect_refused(command, file + "/below", "is a file, not a folder");
  }
  EXPECT_THAT(listing(), testing::ElementsAre("file"));
}

TEST_F(Output, NothingIsMadeWhereTheInputIsWrong) {
  EXPECT_THAT(run({"measure", "--scene", "none", "-o", path("new").string()}).errors, HasSubstr("none"));
  EXPECT_THAT(listing(), IsEmpty());
}

TEST_F(Output, TheCommandInResultsHasNoFolderOfThisMachine) {
  const std::string folder = path("").string();
  const std::string root = "com.example.a=" + folder;
  expect_success({"measure", "--size=32x18", "--map-size=256", "--scene=slabs", "--light=2",
                  "--technique=hard", "--reference-samples=32", "--seeds=1", "--timing-repeats=0",
                  "--no-split", "--cache=" + path("cache").string(), "--output=" + path("out").string(),
                  "--package-root=" + root, "--package-root", root});
  EXPECT_THAT(read("out/results.json"),
              testing::AllOf(testing::Not(HasSubstr(folder)), HasSubstr("--package-root=com.example.a=DIR"),
                             HasSubstr("--package-root com.example.a=DIR")));
}

// Root may write anywhere, so the program runs as nobody where the tests run as root.
TEST_F(Output, AFolderThatNobodyMayWriteToIsRefusedBeforeTheWork) {
  std::filesystem::create_directories(path("locked"));
  std::filesystem::permissions(path("locked"),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec |
                                   std::filesystem::perms::others_read | std::filesystem::perms::others_exec);
  const std::string as_nobody =
      "if [ $(id -u) -eq 0 ]; then as='setpriv --reuid=65534 --clear-groups'; fi; exec $as " PENUMBRA_PROGRAM
      " ";
  for (const char* command : {"render --scene none -o ", "measure --scene none -o "}) {
    const auto result = shell(as_nobody + command + path("locked/new").string());
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, HasSubstr("Permission denied"));
  }
}

}  // namespace
}  // namespace penumbra
