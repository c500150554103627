// Help that can be relied on: every default, bounds that are those in force, examples that parse, names in
// lists.
#include <sstream>

#include "cli/option_values.h"
#include "cli/parse_only.h"
#include "cli/program.h"

namespace penumbra::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(Help, EveryOptionSaysItsDefault) {
  ParseOnly tree;
  for (const CLI::App* command : shown_subcommands(tree.app())) {
    const std::string help = command->help("penumbra");
    for (const CLI::Option* option : command->get_options()) {
      if (value_hint(*option).placeholder.empty() || option->get_required()) continue;
      EXPECT_NE(option->get_default_str(), "") << command->get_name() << " " << option->get_name();
      EXPECT_NE(option->get_default_str(), "[]") << command->get_name() << " " << option->get_name();
      EXPECT_NE(option->get_default_str(), "\"\"") << command->get_name() << " " << option->get_name();
    }
    EXPECT_THAT(help, AllOf(HasSubstr("Exit codes:"), HasSubstr("Examples:"), Not(HasSubstr(" TEXT "))))
        << help;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
      const bool may_be_long = line.starts_with("  penumbra ") || line.find(' ', 26) == std::string::npos;
      EXPECT_TRUE(may_be_long || line.size() <= 112U) << line;
    }
  }
  EXPECT_THAT(ProgramTest::run({"measure", "--help"}).output,
              HasSubstrs("[default: 0.53,2,5]", "[default: 480x270]", "[default: 2048]"));
}

TEST(Help, EveryExampleParses) {
  int examples = 0;
  ParseOnly names;
  for (CLI::App* command : shown_subcommands(names.app())) {
    std::istringstream lines(command->get_footer());
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("  penumbra ") || line.find(" | ") != std::string::npos) continue;
      ++examples;
      std::vector<std::string> words = words_of(line);
      words.erase(words.begin());
      EXPECT_EQ(ParseOnly().refusal(words), "") << line;
    }
  }
  EXPECT_GT(examples, 20);
}

TEST(Help, BoundsAreThoseInForce) {
  int bounded = 0;
  ParseOnly names;
  for (CLI::App* command : shown_subcommands(names.app())) {
    for (const CLI::Option* option : command->get_options()) {
      const ValueHint hint = value_hint(*option);
      if (!hint.bounds) continue;
      ++bounded;
      const auto [low, high] = *hint.bounds;
      const auto given = [&](double value) {
        std::ostringstream text;
        text << std::fixed << value;
        std::string number = text.str();
        number.erase(number.find_last_not_of('0') + 1);
        if (number.ends_with('.')) number.pop_back();
        const int count = option->get_expected_max() <= 7 ? option->get_expected_max() : 1;
        std::string values = number;
        for (int i = 1; i < count; ++i) values += "," + number;
        return ParseOnly().refusal({command->get_name(), option->get_name() + "=" + values});
      };
      const std::string name = command->get_name() + " " + option->get_name();
      for (const double inside : {low, high}) EXPECT_THAT(given(inside), Not(HasSubstr("outside"))) << name;
      for (const double outside : {low - 1, high + 1})
        EXPECT_THAT(given(outside), HasSubstrs("outside", hint.rule)) << name;
    }
  }
  EXPECT_GT(bounded, 25);
}

TEST(Help, NamesAreListed) {
  const auto lines_of = [](const std::vector<std::string>& arguments) {
    const auto result = ProgramTest::run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    std::vector<std::string> lines;
    std::istringstream text(result.output);
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  };
  for (const char* command : {"measure", "render"}) {
    EXPECT_THAT(lines_of({command, "--list-scenes"}),
                testing::Contains(testing::MatchesRegex("contact-boxes +boxes that touch, .*")));
    EXPECT_THAT(lines_of({command, "--list-scenes"}), testing::Each(testing::MatchesRegex("[^ ]+ +[^ ]+ .*")))
        << "a name without a description";
    EXPECT_THAT(lines_of({command, "--list-techniques"}), testing::Contains(testing::StartsWith("tent-5 ")));
  }
  EXPECT_THAT(lines_of({"measure", "--list-techniques"}),
              testing::Contains(testing::MatchesRegex("tent-5 +Tent 5x5")));
  EXPECT_EQ(lines_of({"cost", "--list-techniques"}), lines_of({"measure", "--list-techniques"}));
  const std::string manifest = PENUMBRA_SOURCE_DIR "/tests/techniques/added/Means.technique.json";
  for (const char* command : {"measure", "render", "cost"})
    EXPECT_THAT(lines_of({command, "--list-techniques", "--technique-list", manifest}),
                testing::ElementsAre(testing::StartsWith("means ")))
        << command;
  const std::string variants = PENUMBRA_SOURCE_DIR "/tests/study/StudyVariants.technique.json";
  EXPECT_THAT(lines_of({"measure", "--list-techniques", "--technique-list", variants}),
              AllOf(testing::Contains(testing::StartsWith("tent-5 ")),
                    testing::Contains(testing::StartsWith("box-9 "))));
  const auto absent =
      ProgramTest::run({"cost", "--technique-list", "absent.technique.json", "--list-techniques"});
  EXPECT_EQ(absent.exit_code, 2);
  EXPECT_THAT(absent.errors, HasSubstr("absent.technique.json"));
  EXPECT_THAT(lines_of({"cost", "--list-families"}), testing::Contains(testing::StartsWith("navi21 ")));
  EXPECT_THAT(lines_of({"validate", "--list-targets"}), testing::Contains("essl310"));
  EXPECT_THAT(
      lines_of({"validate", "--list-rules"}),
      testing::Contains(testing::MatchesRegex("divergent-derivative +A derivative is taken where .*\\.")));
  EXPECT_THAT(lines_of({"constants", "--list-settings"}),
              testing::Contains(HasSubstr("`camera.fov_y_degrees`")));
}

TEST(Help, AnUnknownValueNamesTheNearest) {
  const auto result = ProgramTest::run({"tables", "--format", "jsn"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstrs("--format", "'jsn'", "did you mean 'json'?"));
}

}  // namespace
}  // namespace penumbra::cli
