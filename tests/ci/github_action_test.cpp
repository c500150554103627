// Tests action.yml as GitHub reads it, and its script as a runner runs it.
#include <yaml-cpp/yaml.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "ci/project_folder.h"
#include "input/text_file.h"

namespace penumbra::ci {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAreArray;

YAML::Node action() {
  return YAML::LoadFile(repository + "/action.yml");
}

std::set<std::string> names_of(const std::string& kind, const std::string& text) {
  std::set<std::string> names;
  const std::regex pattern("\\b" + kind + "\\.([A-Za-z_-]+)");
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
    names.insert((*it)[1]);
  return names;
}

TEST(GithubAction, DeclaresTheInputsItUsesAndUsesThoseItDeclares) {
  std::set<std::string> declared;
  for (const auto& input : action()["inputs"]) {
    declared.insert(input.first.as<std::string>());
    EXPECT_FALSE(input.second["description"].as<std::string>().empty());
    EXPECT_TRUE(input.second["default"]) << input.first;
  }
  EXPECT_THAT(names_of("inputs", YAML::Dump(action()["runs"])), UnorderedElementsAreArray(declared));
}

TEST(GithubAction, StepsNameOnlyStepsThatAreThere) {
  std::set<std::string> ids;
  for (const auto& step : action()["runs"]["steps"])
    if (step["id"]) ids.insert(step["id"].as<std::string>());
  EXPECT_THAT(names_of("steps", YAML::Dump(action())), UnorderedElementsAreArray(ids));
}

// A tag can be moved to other code, a commit cannot.
TEST(GithubAction, OtherActionsAreNamedByTheirCommit) {
  const std::regex commit("[^@]+@[0-9a-f]{40}");
  int used = 0;
  for (const auto& step : action()["runs"]["steps"]) {
    if (!step["uses"]) continue;
    EXPECT_TRUE(std::regex_match(step["uses"].as<std::string>(), commit)) << step["uses"];
    ++used;
  }
  EXPECT_GT(used, 0);
  const std::string page = read_text_file(repository + "/docs/validating.md");
  const std::regex uses("uses: (\\S+)");
  for (std::sregex_iterator it(page.begin(), page.end(), uses), end; it != end; ++it)
    EXPECT_TRUE((*it)[1] == "OWNER/penumbra@TAG" || std::regex_match((*it)[1].str(), commit)) << (*it)[1];
}

TEST(GithubAction, EveryScriptHasAShellAndNoExpression) {
  EXPECT_EQ(action()["runs"]["using"].as<std::string>(), "composite");
  for (const auto& step : action()["runs"]["steps"]) {
    if (!step["run"]) continue;
    EXPECT_EQ(step["shell"].as<std::string>(), "bash");
    EXPECT_THAT(step["run"].as<std::string>(), Not(HasSubstr("${{"))) << "an input could become a command";
  }
}

// A clone at a tag of its own, as far as the action's scripts read it; its program writes down what it gets.
class GithubTag : public ProjectFolder {
 protected:
  void SetUp() override {
    ProjectFolder::SetUp();
    namespace fs = std::filesystem;
    for (const char* folder : {"tag/cmake", "tag/tools", "tag/scripts", "tag/build/action"})
      fs::create_directories(path(folder));
    fs::copy(repository + "/ci", path("tag/ci"));
    write("tag/CMakeLists.txt", "project(penumbra)\n");
    write("tag/scripts/debian-packages", "cmake\n");
    write_program("tag/scripts/setup", "exit 0");
    write_program("tag/build/action/penumbra", "printf '%s' \"$PENUMBRA_ROOT\" >root");
  }

  void write_program(const std::string& name, const std::string& script) const {
    std::filesystem::permissions(write(name, "#!/bin/bash\n" + script + "\n"),
                                 std::filesystem::perms::owner_all);
  }

  // The key under which the action caches the program on a runner of these variables.
  std::string key_of(std::vector<std::string> variables) const {
    variables.insert(variables.end(), {"GITHUB_ACTION_PATH=" + path("tag").string(),
                                       "GITHUB_OUTPUT=" + path("built").string()});
    std::filesystem::remove(path("built"));
    const auto result = run_in_project(action()["runs"]["steps"][0]["run"].as<std::string>(), variables);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    const std::string written = read("built");
    const std::size_t at = written.find("key=");
    EXPECT_NE(at, std::string::npos) << written;
    return at == std::string::npos ? "" : written.substr(at);
  }
};

TEST_F(GithubTag, ItsCachedProgramReadsTheShadersOfThisTag) {
  const YAML::Node steps = action()["runs"]["steps"];
  const auto result =
      run_in_project(steps[steps.size() - 1]["run"].as<std::string>(),
                     {"GITHUB_ACTION_PATH=" + path("tag").string(), "SHARD=1/2", "REPORTS=reports"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(read("root"), path("tag").string());
}

// A program is linked to the libraries of the image that it was built on.
TEST_F(GithubTag, ACachedProgramIsOfOneImageAndOneSetOfSources) {
  const std::string key = key_of({"ImageOS=ubuntu24", "ImageVersion=20261101.1"});
  EXPECT_EQ(key_of({"ImageOS=ubuntu24", "ImageVersion=20261101.1"}), key);
  EXPECT_NE(key_of({"ImageOS=ubuntu24", "ImageVersion=20261108.1"}), key);
  EXPECT_NE(key_of({"ImageOS=ubuntu26", "ImageVersion=20261101.1"}), key);
  std::filesystem::create_directories(path("bin"));
  write_program("bin/dpkg-query", "echo a-library 2.0");
  EXPECT_NE(key_of({"ImageOS=ubuntu24", "ImageVersion=20261101.1",
                    "PATH=" + path("bin").string() + ":/usr/bin:/bin"}),
            key)
      << "a container has no ImageVersion, but its packages";
  write("tag/tools/main.cpp", "int main() {}\n");
  EXPECT_NE(key_of({"ImageOS=ubuntu24", "ImageVersion=20261101.1"}), key);
}

// Runs the last step with its inputs, as the runner sets its environment.
class GithubRun : public ProjectFolder {
 protected:
  platform::ChildResult run_step(std::map<std::string, std::string> inputs, const std::string& folder = ".") {
    for (const auto& input : action()["inputs"])
      inputs.try_emplace(input.first.as<std::string>(), input.second["default"].as<std::string>());
    const YAML::Node steps = action()["runs"]["steps"];
    const YAML::Node step = steps[steps.size() - 1];
    std::vector<std::string> variables{"GITHUB_ACTIONS=true", "GITHUB_ACTION_PATH=" + repository,
                                       "GITHUB_WORKSPACE=" + path("").parent_path().string(),
                                       "GITHUB_OUTPUT=" + path("output").string(),
                                       "GITHUB_STEP_SUMMARY=" + path("summary.md").string()};
    for (const auto& variable : step["env"]) {
      const std::string expression = variable.second.as<std::string>();
      const std::string input = *names_of("inputs", expression).begin();
      EXPECT_EQ(expression, "${{ inputs." + input + " }}");
      variables.push_back(variable.first.as<std::string>() + "=" + inputs.at(input));
    }
    return run_in_project("cd '" + folder + "'\n" + step["run"].as<std::string>(), variables);
  }

  nlohmann::json read_json(const std::string& name) const { return nlohmann::json::parse(read(name)); }
};

TEST_F(GithubRun, AMistakeIsAnAnnotationASarifResultAndAFailedTest) {
  const auto result =
      run_step({{"program", PENUMBRA_PROGRAM},
                {"arguments", "Assets/Good.hlsl \"Assets/Broken.hlsl\" --target spirv,msl23"}});
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("::error file=Assets/Broken.hlsl,line=3,col=22,title=penumbra%3A "
                                       "hlsl::unknown variable 'glow'%0A"));
  EXPECT_EQ(read_json("penumbra-reports/penumbra.json").at("summary").at("results"), 4);
  EXPECT_EQ(read_json("penumbra-reports/penumbra.sarif").at("runs").at(0).at("results").size(), 1u);
  // Each target is made from a source of its own, so the mistake is in both.
  EXPECT_THAT(read("penumbra-reports/penumbra.xml"), HasSubstr("failures=\"2\""));
  EXPECT_THAT(read("summary.md"),
              AllOf(HasSubstr("Broken.hlsl:3:22: error:"), HasSubstr("```text\n"), EndsWith("\n```\n")));
  EXPECT_EQ(read("output"),
            "json=penumbra-reports/penumbra.json\nsarif=penumbra-reports/penumbra.sarif\n"
            "junit=penumbra-reports/penumbra.xml\n");
}

TEST_F(GithubRun, ReportsOfAProjectBelowTheWorkspaceAreNamedFromThere) {
  write("Game/Assets/Broken.hlsl", read("Assets/Broken.hlsl"));
  const auto result =
      run_step({{"program", PENUMBRA_PROGRAM}, {"arguments", "Assets/Broken.hlsl --target spirv"}}, "Game");
  EXPECT_THAT(result.output, HasSubstr("::error file=Game/Assets/Broken.hlsl,line=3"));
  EXPECT_THAT(read("output"), HasSubstr("sarif=Game/penumbra-reports/penumbra.sarif\n"));
  EXPECT_EQ(read_json("Game/penumbra-reports/penumbra.sarif").at("runs").at(0).at("results").size(), 1u);
}

// A line of a shader closes a fence and goes on in Markdown.
TEST_F(GithubRun, TheSummarysFenceIsLongerThanAnyInTheText) {
  const std::string backticks(12, '`');
  write("Assets/Broken.hlsl", "float4 Main() : SV_Target {\n" + backticks + "\n}\n");
  run_step({{"program", PENUMBRA_PROGRAM}, {"arguments", "Assets/Broken.hlsl --target spirv"}});
  const std::string summary = read("summary.md");
  EXPECT_THAT(summary, HasSubstr(backticks + "\n"));
  EXPECT_THAT(summary, HasSubstr("\n" + backticks + "`text\n"));
  EXPECT_THAT(summary, EndsWith("\n" + backticks + "`\n"));
}

TEST_F(GithubRun, GoodShadersAreSuccess) {
  const auto result = run_step({{"program", PENUMBRA_PROGRAM}, {"arguments", "Assets/Good.hlsl"}});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, Not(HasSubstr("::error")));
}

TEST_F(GithubRun, BadInputKeepsItsCodeAndLeavesNoReport) {
  const auto result = run_step({{"program", PENUMBRA_PROGRAM}, {"arguments", "Assets/Missing.hlsl"}});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("Missing.hlsl"));
  EXPECT_FALSE(std::filesystem::exists(path("penumbra-reports/penumbra.json")));
  EXPECT_EQ(run_step({{"program", PENUMBRA_PROGRAM}, {"arguments", "'Assets/Good.hlsl"}}).exit_code, 2);
}

// The next step uploads the SARIF that lies there, whatever the run came to.
TEST_F(GithubRun, WhatACheckoutOrAnEarlierRunLeftIsNoReportOfThisOne) {
  const std::vector<std::map<std::string, std::string>> runs{
      {{"program", PENUMBRA_PROGRAM}, {"arguments", "Assets/Missing.hlsl"}},
      {{"program", PENUMBRA_PROGRAM}, {"arguments", "'Assets/Good.hlsl"}},
      {{"program", PENUMBRA_PROGRAM}, {"merge", "missing.json"}},
      {{"program", "/no/such/penumbra"}}};
  for (const auto& inputs : runs) {
    std::filesystem::create_directories(path("penumbra-reports"));
    for (const char* form : {"json", "sarif", "xml", "txt"})
      write(std::string("penumbra-reports/penumbra.") + form, "forged");
    write("penumbra-reports/notes.md", "a person's");
    EXPECT_GE(run_step(inputs).exit_code, 2);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("penumbra-reports")), {}), 1)
        << inputs.begin()->second;
    EXPECT_EQ(read("penumbra-reports/notes.md"), "a person's");
  }
}

TEST_F(GithubRun, ALinkedFolderOfReportsIsNotFollowed) {
  std::filesystem::create_directories(path("elsewhere"));
  write("elsewhere/penumbra.json", "another's");
  std::filesystem::create_directory_symlink("elsewhere", path("penumbra-reports"));
  for (const std::map<std::string, std::string>& inputs :
       {std::map<std::string, std::string>{{"program", PENUMBRA_PROGRAM}, {"arguments", "Assets/Good.hlsl"}},
        {{"program", PENUMBRA_PROGRAM}, {"merge", "elsewhere/penumbra.json"}}}) {
    const auto result = run_step(inputs);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, HasSubstr("behind the link 'penumbra-reports', which is not followed"));
    EXPECT_EQ(read("elsewhere/penumbra.json"), "another's");
  }
}

TEST_F(GithubRun, NothingIsRemovedBehindALinkedFolder) {
  write("elsewhere/r/penumbra.txt", "another's");
  write("elsewhere/penumbra.txt", "another's");
  std::filesystem::create_directory_symlink("elsewhere", path("out"));
  for (const char* script : {"validate", "merge x.json"})
    for (const char* reports : {"out/r", "out/.", "out/new/r"}) {
      const auto result = run_in_project(
          std::string(PENUMBRA_SOURCE_DIR) + "/ci/" + script,
          {std::string("REPORTS=") + reports, "PENUMBRA=" PENUMBRA_PROGRAM, "ARGUMENTS=Assets/Good.hlsl"});
      EXPECT_EQ(result.exit_code, 2) << reports;
      EXPECT_THAT(result.errors, HasSubstr("behind the link 'out', which is not followed"));
    }
  EXPECT_EQ(read("elsewhere/r/penumbra.txt"), "another's");
  EXPECT_EQ(read("elsewhere/penumbra.txt"), "another's");
  EXPECT_FALSE(std::filesystem::exists(path("elsewhere/new")));
}

// The run would check the tool's own library, and be green whatever the project holds.
TEST_F(GithubRun, WithoutAnythingToValidateItFails) {
  for (const char* arguments : {"", "  ", "--target spirv", "--unity-version 6000.0 --jobs 2"}) {
    const auto result = run_step({{"program", PENUMBRA_PROGRAM}, {"arguments", arguments}});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, AllOf(HasSubstr("there is nothing to validate"), HasSubstr("--project")));
    EXPECT_FALSE(std::filesystem::exists(path("penumbra-reports/penumbra.json")));
  }
}

TEST_F(GithubRun, AMissingProgramIsTheEnvironmentsFault) {
  EXPECT_EQ(run_step({{"program", "/no/such/penumbra"}}).exit_code, 3);
}

TEST_F(GithubRun, AFolderThatCannotBeMadeIsNoFinding) {
  EXPECT_EQ(run_step({{"program", PENUMBRA_PROGRAM}, {"reports", "/proc/reports"}}).exit_code, 2);
}

TEST_F(GithubRun, ArgumentsAreNeverRun) {
  const std::string hostile = "$(touch ran) `touch ran` ; touch ran";
  run_step({{"program", stub_program(2).string()}, {"arguments", hostile}});
  EXPECT_FALSE(std::filesystem::exists(path("ran")));
  EXPECT_THAT(read("called"), HasSubstr("$(touch\nran)\n`touch\nran`\n;\ntouch\nran\n"));
}

TEST_F(GithubRun, AShardIsHandedOnAndItsReportIsLeftForTheMerge) {
  const auto result =
      run_step({{"program", stub_program(0).string()}, {"arguments", "--project ."}, {"shard", "2/4"}});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(read("called"),
            "validate\n--project\n.\n--require-sources\n--shard\n2/4\n--format\njson\n-o\npenumbra-reports/"
            "penumbra.json\n");
}

TEST_F(GithubRun, ReportsOfAllShardsAreJoined) {
  std::string shards;
  for (const std::string name : {"Good", "Broken"}) {
    const std::string file = path(name + ".json").string();
    run({"validate", path("Assets/" + name + ".hlsl").string(), "--format", "json", "-o", file});
    nlohmann::json shard = read_json(name + ".json");
    shard["shard"] = {{"index", name == "Good" ? 1 : 2}, {"count", 2}};
    shard["fingerprint"] = "of one request";
    write(name + ".json", shard.dump());
    shards += file + "\n\n";
  }
  const auto result = run_step({{"program", PENUMBRA_PROGRAM}, {"merge", shards}});
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_EQ(read_json("penumbra-reports/penumbra.json").at("summary").at("results"), 10);
  EXPECT_THAT(result.output, HasSubstr("::error file=Assets/Broken.hlsl,line=3"));
}

}  // namespace
}  // namespace penumbra::ci
