// The snippet for GitLab: its jobs run as a runner would, four shards and then the report.
#include <yaml-cpp/yaml.h>

#include "ci/project_folder.h"

namespace penumbra::ci {
namespace {

using testing::HasSubstr;

class Gitlab : public ProjectFolder {
 protected:
  // A job's script with the file's variables and the job's, each expanded from those before it.
  platform::ChildResult run_job(const std::string& job, const std::vector<std::string>& given) {
    std::string script;
    for (const YAML::Node& variables : {file_["variables"], file_[job]["variables"]})
      for (const auto& variable : variables)
        if (!is_given(given, variable.first.as<std::string>()))
          script += "export " + variable.first.as<std::string>() + "=\"" + variable.second.as<std::string>() +
                    "\"\n";
    for (const auto& line : file_[job]["script"]) script += line.as<std::string>() + "\n";
    return run_in_project(script, given);
  }

  YAML::Node file_ = YAML::LoadFile(repository + "/ci/gitlab.yml");

 private:
  static bool is_given(const std::vector<std::string>& given, const std::string& name) {
    return std::any_of(given.begin(), given.end(),
                       [&](const std::string& variable) { return variable.starts_with(name + "="); });
  }
};

TEST_F(Gitlab, EveryShardIsAskedFor) {
  const int shards = file_["penumbra"]["parallel"].as<int>();
  for (int index = 1; index <= shards; ++index) {
    const auto result =
        run_job("penumbra", {"PENUMBRA_CLONE=" + repository, "PENUMBRA=" + stub_program(0).string(),
                             "PENUMBRA_ARGUMENTS=--jobs 2", "CI_NODE_INDEX=" + std::to_string(index),
                             "CI_NODE_TOTAL=" + std::to_string(shards)});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    const std::string number = std::to_string(index);
    EXPECT_THAT(read("called"),
                HasSubstr("validate\n--jobs\n2\n--require-sources\n--shard\n" + number +
                          "/4\n--format\njson\n-o\npenumbra-shards/" + number + "/penumbra.json\n"));
  }
}

TEST_F(Gitlab, TheReportJobWritesTheJunitArtifactAndFails) {
  std::filesystem::create_directories(path("penumbra-shards/1"));
  run({"validate", path("Assets/Broken.hlsl").string(), "--format", "json", "-o",
       path("penumbra-shards/1/penumbra.json").string()});
  const auto result =
      run_job("penumbra-report", {"PENUMBRA_CLONE=" + repository, std::string("PENUMBRA=") + PENUMBRA_PROGRAM,
                                  "CI_PROJECT_DIR=" + path("").parent_path().string()});
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("Broken.hlsl:3:22: error: unknown variable 'glow'"));
  const std::string junit = file_["penumbra-report"]["artifacts"]["reports"]["junit"].as<std::string>();
  EXPECT_THAT(read(junit), HasSubstr("<testsuite name=\"Assets/Broken.hlsl\""));
}

}  // namespace
}  // namespace penumbra::ci
