// What a mistyped command is answered: the nearest right name, and where the help is.
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Usage : public ProgramTest {
 protected:
  static void expect_refused(const std::vector<std::string>& arguments,
                             const std::vector<std::string>& words) {
    const auto result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_THAT(result.errors, StartsWith("penumbra: "));
    for (const std::string& word : words) EXPECT_THAT(result.errors, HasSubstr(word));
  }
};

TEST_F(Usage, TheProgramAloneIsAnsweredWithItsHelp) {
  const auto result = run({});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.errors, IsEmpty());
  EXPECT_EQ(result.output, run({"--help"}).output);
  EXPECT_EQ(result.output, run({"help"}).output);
}

TEST_F(Usage, HelpOfASubcommandHasTwoWays) {
  EXPECT_EQ(run({"help", "measure"}).output, run({"measure", "--help"}).output);
  EXPECT_THAT(run({"help", "measure"}).output, HasSubstr("--reference-samples"));
  expect_refused({"help", "mesure"}, {"did you mean 'measure'?"});
}

TEST_F(Usage, AnUnknownSubcommandNamesTheNearestOrAll) {
  expect_refused({"mesure"},
                 {"there is no subcommand 'mesure'", "did you mean 'measure'?", "penumbra --help"});
  expect_refused({"mesure", "--scene", "trees"}, {"'mesure'", "'measure'"});
  expect_refused({"banana"}, {"known are:", "constants", "validate", "render"});
  EXPECT_THAT(run({"banana"}).errors, Not(HasSubstr("worker"))) << "a process of the program's own";
}

TEST_F(Usage, AnUnknownOptionNamesTheNearest) {
  expect_refused({"measure", "--lihgt", "2"},
                 {"penumbra measure has no option '--lihgt'", "'--light'", "penumbra measure --help"});
  expect_refused({"measure", "--lihgt=2"}, {"'--lihgt'", "'--light'"});
  expect_refused({"render", "--reference-sample", "64"}, {"'--reference-samples'"});
  expect_refused({"--versoin"}, {"'--version'"});
  expect_refused({"tables", "--quite"}, {"'--quiet'"});  // an option of all subcommands
  expect_refused({"tables", "--zzzzzzzzzzz"}, {"'--zzzzzzzzzzz'", "penumbra tables --help"});
}

TEST_F(Usage, WhatIsCalledOtherwiseElsewhereIsNamed) {
  expect_refused({"validate", "--report", "json"}, {"'--format'"});
  expect_refused({"validate", "--targets", "spirv"}, {"'--target'"});
  expect_refused({"validate", "--list"}, {"'--count'"});
  expect_refused({"constants", "--angle", "2"}, {"'--light'"});
  expect_refused({"constants", "--resolution", "1024"}, {"'--map-size'"});
  expect_refused({"render", "--conventional-z"}, {"'--reversed-z'"});
  expect_refused({"cost", "--threads", "2"}, {"'--jobs'"});
}

TEST_F(Usage, WhatIsTooMuchIsNamed) {
  expect_refused({"measure", "trees"}, {"penumbra measure does not expect 'trees'"});
}

}  // namespace
}  // namespace penumbra
