// A run does not replace the files that it reads, or source files, by what it writes.
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::HasSubstr;

constexpr const char* kShader = "float4 Main() : SV_Target { return 1; }\n";
constexpr const char* kManifest =
    R"({"structs": [{"name": "RingParameters", "doc": "A ring.", "fields": [
         {"name": "taps", "type": "int", "unit": "taps", "doc": "on it", "range": [4, 32], "default": 8}]}],
        "techniques": [{"name": "ring", "title": "Ring", "family": "ring", "source": "a test",
          "filter": {"file": "Ring.hlsl", "function": "FilterRing", "arguments": ["shadowMap"],
                     "parameters": "RingParameters"}}]})";

class KeptFiles : public ProgramTest {
 protected:
  std::string write_ring(const std::string& folder = "") const {
    write(folder + "Ring.hlsl", "float FilterRing();\n");
    return write(folder + "Ring.technique.json", kManifest).string();
  }

  // The run must end with exit code 2 and these words, and leave the file as it is.
  void expect_kept(const std::string& name, const std::vector<std::string>& arguments,
                   const std::string& words) const {
    const std::string before = read(name);
    expect_bad_input(arguments, HasSubstr(words));
    EXPECT_EQ(read(name), before);
  }
};

TEST_F(KeptFiles, ReportsDoNotReplaceSources) {
  const std::string shader = write("S.hlsl", kShader).string();
  const std::string include = write("Shared.hlsl", "float a;\n").string();
  const std::string manifest = write_ring();
  for (const char* subcommand : {"validate", "cost"}) {
    expect_kept("S.hlsl", {subcommand, shader, "-o", shader}, "--output: ");
    expect_kept("Shared.hlsl", {subcommand, shader, "-o", include}, "is a source file");
    expect_kept("Ring.technique.json", {subcommand, "--technique-list", manifest, "-o", manifest},
                "--output: ");
  }
  const std::vector<std::string> copy{"emit", "--technique-list", manifest, "--single-file", "ring", "-o"};
  const auto onto = [&](const std::string& file) {
    std::vector<std::string> arguments = copy;
    arguments.push_back(file);
    return arguments;
  };
  expect_kept("Ring.technique.json", onto(manifest), "--output: ");
  expect_kept("Ring.hlsl", onto(path("Ring.hlsl").string()), "--output: ");
  expect_kept("Shared.hlsl", onto(include), "exists and was not written by penumbra");
}

TEST_F(KeptFiles, InputsAreNotOutputs) {
  const std::string settings = write("settings.json", "{}").string();
  expect_kept("settings.json", {"constants", "--config", settings, "-o", path("./settings.json").string()},
              "is a file that this run reads");
  const std::string report = write("report.json", "{}").string();
  std::filesystem::create_hard_link(report, path("same.json"));
  expect_kept("report.json", {"merge", report, "-o", path("same.json").string()},
              "is a file that this run reads");
  expect_kept("report.json", {"cost", "--from", report, "-o", report}, "is a file that this run reads");
}

TEST_F(KeptFiles, GeneratedSourcesReplaceGeneratedOnesAlone) {
  const std::string manifest = write_ring();
  const std::vector<std::string> emit{"emit", "--technique-list", manifest};
  EXPECT_EQ(run(emit).exit_code, 0);
  EXPECT_THAT(read("Parameters/RingParameters.hlsl"), HasSubstr("int taps;"));
  write("Parameters/RingParameters.hlsl", "// Written by `penumbra`, in an earlier version.\n");
  EXPECT_EQ(run(emit).exit_code, 0);
  EXPECT_THAT(read("Parameters/RingParameters.hlsl"), HasSubstr("int taps;"))
      << "its own file is written again";
  write("Parameters/RingParameters.hlsl", "// mine\n");
  std::filesystem::remove_all(path("Runtime"));
  expect_kept("Parameters/RingParameters.hlsl", emit, "exists and was not written by penumbra");
  EXPECT_FALSE(std::filesystem::exists(path("Runtime/Parameters/RingParameters.cs"))) << "all or none";
}

// A checkout's links lead nowhere else; the package that the user names may be one.
TEST_F(KeptFiles, GeneratedSourcesFollowNoLink) {
  namespace fs = std::filesystem;
  const auto emit = [&] { return run({"emit", "--technique-list", write_ring("package/")}); };
  for (const char* linked :
       {"package/Runtime", "package/Runtime/Parameters", "package/Parameters/RingParameters.hlsl",
        "package/Runtime/Parameters/RingParameters.cs"}) {
    fs::remove_all(path("package"));
    fs::create_directories(path(linked).parent_path());
    fs::create_directories(path("elsewhere"));
    fs::create_symlink(path("elsewhere"), path(linked));
    const auto result = emit();
    EXPECT_EQ(result.exit_code, 2) << linked;
    EXPECT_THAT(result.errors, HasSubstrs(path(linked).string(), "is a symbolic link"));
    EXPECT_TRUE(fs::is_empty(path("elsewhere"))) << linked;
  }
  fs::remove_all(path("package"));
  fs::create_directory_symlink(path("elsewhere"), path("package"));
  EXPECT_EQ(emit().exit_code, 0);
  EXPECT_THAT(read("elsewhere/Parameters/RingParameters.hlsl"), HasSubstr("int taps;"));
}

TEST_F(KeptFiles, AReportThatWouldLackAShaderIsNotWritten) {
  const std::string shader = write("F.hlsl", "float4 Main() : SV_Target { return nope; }\n").string();
  write("costs.txt", "before");
  const auto result = run({"cost", shader, "--family", "navi21", "-o", path("costs.txt").string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors,
              HasSubstrs("unknown variable 'nope'", "costs.txt was not written, because of these errors"));
  EXPECT_EQ(read("costs.txt"), "before");
}

}  // namespace
}  // namespace penumbra
