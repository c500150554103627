// Tests VS Code's problem matcher over what the program really prints.
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "ci/project_folder.h"

namespace penumbra::ci {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Problem {
  std::string file;
  int line = 0;
  int column = 0;
  std::string severity;
  std::string message;
  bool operator==(const Problem&) const = default;
};

// The problems that VS Code finds: it applies each of a list of matchers to each line.
std::vector<Problem> problems_in(const std::string& output) {
  std::ifstream file(repository + "/ci/vscode-tasks.json");
  const nlohmann::json matchers = nlohmann::json::parse(file).at("tasks").at(0).at("problemMatcher");
  std::vector<Problem> problems;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
    for (const nlohmann::json& matcher : matchers) {
      const nlohmann::json& pattern = matcher.at("pattern");
      std::smatch match;
      if (!std::regex_match(line, match, std::regex(pattern.at("regexp").get<std::string>()))) continue;
      const auto group = [&](const char* name) {
        return pattern.contains(name) ? match[pattern.at(name).get<std::size_t>()].str() : std::string();
      };
      const auto number = [&](const char* name) { return group(name).empty() ? 0 : std::stoi(group(name)); };
      problems.push_back(
          {group("file"), number("line"), number("column"), group("severity"), group("message")});
    }
  return problems;
}

class ProblemMatcher : public ProjectFolder {
 protected:
  std::vector<Problem> problems_of(const std::string& text) {
    const std::string file = write("Assets/Shader.hlsl", text).string();
    std::vector<Problem> problems = problems_in(run({"validate", file, "--target", "spirv"}).output);
    for (Problem& problem : problems) EXPECT_EQ(std::exchange(problem.file, {}), file);
    return problems;
  }
};

TEST_F(ProblemMatcher, FindsThePlaceOfAnError) {
  EXPECT_THAT(problems_of("float4 Main() : SV_Target\n{\n    return glow;\n}\n"),
              ElementsAre(Problem{"", 3, 12, "error", "unknown variable 'glow'"}));
}

TEST_F(ProblemMatcher, FindsWarnings) {
  EXPECT_THAT(problems_of("static const float a;\nfloat4 Main() : SV_Target { return a; }\n"),
              ElementsAre(Problem{"", 1, 20, "warning",
                                  "variable with qualifier 'const' not initialized; zero initializing 'a'"}));
}

TEST_F(ProblemMatcher, FindsErrorsOfWholeFiles) {
  EXPECT_THAT(problems_of("float4 Frag() : SV_Target { return 1; }\n"),
              ElementsAre(Problem{"", 0, 0, "error", "the entry point 'Main' is not defined"}));
}

TEST_F(ProblemMatcher, FindsNothingInTheRestOfTheText) {
  EXPECT_THAT(problems_of("float4 Main() : SV_Target { return 1; }\n"), IsEmpty());
}

TEST(ProblemMatcherPatterns, TellLinesAndColumnsFromNames) {
  EXPECT_THAT(problems_in("C:\\Project\\a.hlsl:3:5: error: m: n\n"),
              ElementsAre(Problem{"C:\\Project\\a.hlsl", 3, 5, "error", "m: n"}));
  EXPECT_THAT(problems_in("a b.hlsl:3: note: m\n"), ElementsAre(Problem{"a b.hlsl", 3, 0, "note", "m"}));
  EXPECT_THAT(problems_in("a.hlsl: warning: m [rule]\n"),
              ElementsAre(Problem{"a.hlsl", 0, 0, "warning", "m [rule]"}));
}

}  // namespace
}  // namespace penumbra::ci
