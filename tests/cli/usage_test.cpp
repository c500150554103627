// A mistyped command is answered with the nearest right name, and with where the help is.
#include "cli/option_values.h"
#include "cli/parse_only.h"
#include "cli/program.h"

namespace penumbra {
namespace {

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
  expect_refused({"mesure"}, {"unknown subcommand 'mesure'", "did you mean 'measure'?", "penumbra --help"});
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

TEST_F(Usage, AnUnknownValueIsFollowedByTheKnownOnesOnALineOfTheirOwn) {
  expect_refused(
      {"validate", "a.hlsl", "--stage", "foo"},
      {"--stage: unknown value 'foo'\n  known are: vertex hull domain geometry fragment compute\n"});
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

TEST_F(Usage, BoundsThatAreOutsideThemselvesAreInHelpAndInForce) {
  const std::string help = run({"constants", "--help"}).output;
  EXPECT_THAT(help, HasSubstrs("full angle; between 0 and 180", "between 0 and 1 ["));
  expect_refused({"constants", "--fov", "0"}, {"--fov: 0 is not between 0 and 180"});
  expect_refused({"constants", "--fov", "180"}, {"--fov: 180 is not between 0 and 180"});
  expect_refused({"constants", "--fov", "wide"}, {"--fov: 'wide' is not a number"});
  expect_refused({"constants", "--cascades", "3", "--splits", "0.5,1"},
                 {"--splits: 1 is not between 0 and 1"});
  EXPECT_EQ(run({"constants", "--fov", "179.5"}).exit_code, 0);
}

TEST_F(Usage, ANoiseMaskIsNoDisk) {
  expect_refused({"tables", "--noise-mask", "--format", "hlsl"}, {"table or json", "--format json"});
  expect_refused({"tables", "--noise-mask", "--generate"}, {"--noise-mask", "--generate"});
}

TEST_F(Usage, WhatIsTooMuchIsNamed) {
  expect_refused({"measure", "--reference-samples", "32", "--reference-samples", "64"},
                 {"--reference-samples is given twice"});
  expect_refused({"tables", "-o", "a", "-o", "b", "--output", "c"}, {"--output is given 3 times"});
  expect_refused({"measure", "--origin", "1,2"}, {"--origin takes at least 3 numbers, not 2"});
  expect_refused({"measure", "--origin", "1,2,3,4"}, {"--origin takes at most 3 numbers, not 4"});
  expect_refused({"measure", "--from"}, {"--from is given without its FILE"});
  expect_refused({"validate", "--jobs"}, {"--jobs is given without its N"});
  expect_refused({"validate", "--quiet=maybe"}, {"--quiet does not take the value 'maybe'"});
  expect_refused({"measure", "trees"}, {"penumbra measure does not expect 'trees'"});
  expect_refused({"measure", "--history", "0"}, {"--history: 0 is outside 0.01 .. 1"});
}

// Such an option would have the whole program measure all night, for nothing.
TEST_F(Usage, AnOptionIsRefusedWithoutTheOneThatItIsFor) {
  expect_refused({"measure", "--earlier", "results.tsv"}, {"--earlier needs --earlier-rows"});
  expect_refused({"measure", "--earlier-rows", "hard"}, {"--earlier-rows needs --earlier"});
}

// Names stand in READMEs, captions and messages.
TEST_F(Usage, ANameOfAnotherKindOfTextIsRefused) {
  const std::vector<std::string> render{"render", "--technique", "hard"};
  const auto refused = [&](const std::string& option, const std::string& value, const std::string& why) {
    std::vector<std::string> arguments = render;
    arguments.insert(arguments.end(), {option, value});
    expect_refused(arguments, {option + ": the name '", why});
  };
  refused("--title", "hard=a --> <!-- results:end -->", "holds '<!--'");
  refused("--title", "hard=a -->", "holds '-->'");
  refused("--title", "hard=a\nb", "'hard=a\\x0Ab' holds a control character");
  refused("--title", "hard=\x1B[2J", "\\x1B[2J");
  refused("--title", "hard=\a", "\\x07");
  refused("--adapter", "a\nb=mine.hlsl", "control character");
  refused("--adapter", "<!--=mine.hlsl", "holds '<!--'");
  refused("--scene", "a\x1B.obj", "control character");
  refused("--scene", "<!-- results:end -->.obj", "holds '<!--'");
}

// An empty name comes from "$UNSET" of a script.
TEST_F(Usage, AnEmptyNameOfAFileIsRefused) {
  int options = 0;
  cli::ParseOnly names;
  for (CLI::App* command : cli::shown_subcommands(names.app())) {
    for (const CLI::Option* option : command->get_options()) {
      const std::string placeholder = cli::value_hint(*option).placeholder;
      if (placeholder != "FILE" && placeholder != "FOLDER" && placeholder != "SCENE") continue;
      ++options;
      const std::vector<std::string> given{option->nonpositional() ? option->get_name() : "--", ""};
      std::vector<std::string> arguments{command->get_name()};
      arguments.insert(arguments.end(), given.begin(), given.end());
      EXPECT_THAT(cli::ParseOnly().refusal(arguments), HasSubstr("is empty"))
          << command->get_name() << " " << option->get_name();
    }
  }
  EXPECT_GT(options, 30);
  expect_refused({"measure", "--from", ""}, {"--from is empty"});
  expect_refused({"measure", "--from="}, {"--from"});
  expect_refused({"measure", "-o", ""}, {"--output is empty"});
  expect_refused({"render", "--sheet", ""}, {"--sheet is empty"});
  expect_refused({"render", "--device", ""}, {"--device is empty"});
}

TEST_F(Usage, EarlierFiguresAreNotMeasuredOtherwise) {
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{{"--light", "2"},
                                                                                      {"--scene", "trees"},
                                                                                      {"--technique", "hard"},
                                                                                      {"--title", "hard=x"},
                                                                                      {"--no-ground"},
                                                                                      {"--size", "32x32"}}) {
    std::vector<std::string> arguments{"measure", "--from", "results.json"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    expect_refused(arguments,
                   {"--from takes its figures from the file; " + option.front() + " has no effect"});
  }
  expect_refused({"cost", "--from", "cost.json", "--define", "A"}, {"--define has no effect"});
  expect_refused({"measure", "--from", "none.json", "-q"}, {"none.json"});
}

}  // namespace
}  // namespace penumbra
