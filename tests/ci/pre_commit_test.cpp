// The hook in git repositories of its own.
#include <yaml-cpp/yaml.h>

#include <regex>

#include "ci/project_folder.h"

namespace penumbra::ci {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class PreCommit : public ProjectFolder {
 protected:
  void SetUp() override {
    ProjectFolder::SetUp();
    git("git init -q . && git config user.name T && git config user.email t@example.com");
  }

  void git(const std::string& script) {
    const auto result = run_in_project(script);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
  }

  platform::ChildResult hook(const std::string& arguments, const std::string& program = PENUMBRA_PROGRAM) {
    return run_in_project("'" + repository + "/ci/pre-commit' " + arguments, {"PENUMBRA=" + program});
  }
};

TEST_F(PreCommit, ValidatesTheFilesItIsGiven) {
  git("git add .");
  const auto broken = hook("--target spirv -- Assets/Good.hlsl Assets/Broken.hlsl");
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_THAT(broken.output, AllOf(HasSubstr("Assets/Broken.hlsl:3:22: error: unknown variable 'glow'"),
                                   HasSubstr("2 variants for 1 target")));
  EXPECT_EQ(hook("-- Assets/Good.hlsl").exit_code, 0);
}

TEST_F(PreCommit, LooksAtWhatIsStagedNotAtTheWorkingTree) {
  git("git add .");
  write("Assets/Broken.hlsl", read("Assets/Good.hlsl"));  // mended, and not staged
  EXPECT_EQ(hook("-- Assets/Broken.hlsl").exit_code, 1);
  git("git add .");
  write("Assets/Broken.hlsl", "not HLSL\n");
  EXPECT_EQ(hook("-- Assets/Broken.hlsl").exit_code, 0);
}

TEST_F(PreCommit, StagedIncludesAreFound) {
  write("Assets/Part.hlsl", "float Half(float x) { return 0.5 * x; }\n");
  write("Assets/Good.hlsl",
        "#include \"Part.hlsl\"\nfloat4 Main(float2 uv : TEXCOORD0) : SV_Target { return Half(uv.x); }\n");
  git("git add . && rm Assets/Part.hlsl");
  EXPECT_EQ(hook("-- Assets/Good.hlsl").exit_code, 0);
}

TEST_F(PreCommit, IncludesMayHaveAnyExtension) {
  write("Common/Quarter", "float Quarter(float x) { return 0.25 * x; }\n");
  write("Assets/Half.hlsli",
        "#include <../Common/Quarter>\nfloat Half(float x) { return 2 * Quarter(x); }\n");
  write("Assets/Part.inc", "#\tinclude \"Half.hlsli\"\n");
  write("Assets/Good.hlsl",
        "# include  \"Part.inc\"\nfloat4 Main(float2 uv : TEXCOORD0) : SV_Target { return Half(uv.x); }\n");
  git("git add . && rm Common/Quarter Assets/Half.hlsli Assets/Part.inc");
  const auto result = hook("-- Assets/Good.hlsl");
  EXPECT_EQ(result.exit_code, 0) << result.output << result.errors;
}

TEST_F(PreCommit, IncludesMayLeadAnywhereInTheRepositoryAndNotOutOfIt) {
  write("Common/Part.hlsl", "float Half(float x) { return 0.5 * x; }\n");
  const std::string main = "float4 Main(float2 uv : TEXCOORD0) : SV_Target { return Half(uv.x); }\n";
  write("Assets/Good.hlsl", "#include \"../Common/Part.hlsl\"\n" + main);
  git("git add .");
  EXPECT_EQ(hook("-- Assets/Good.hlsl").exit_code, 0);
  write("Assets/Good.hlsl", "#include \"../../../etc/hostname\"\n" + main);
  git("git add .");
  const auto outside = hook("-- Assets/Good.hlsl");
  EXPECT_EQ(outside.exit_code, 1);
  EXPECT_THAT(outside.output, HasSubstr("outside of the project"));
}

// Unity's packages lie in Library/, which is not in git.
TEST_F(PreCommit, ReadsThePackagesThatUnityDownloaded) {
  write(".gitignore", "Library/\n");
  write("Packages/manifest.json", R"({"dependencies": {"com.acme.fx": "1.0.0", "com.acme.own": "1.0.0"}})");
  write("ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 2021.3.5f1\n");
  write("Library/PackageCache/com.acme.fx@1.0.0/package.json",
        R"({"name": "com.acme.fx", "version": "1.0.0"})");
  write("Library/PackageCache/com.acme.fx@1.0.0/Half.hlsl",
        "float Half(float x) { return 0.5 * x; }\n#define UNITY UNITY_VERSION\n");
  write("Packages/com.acme.own/package.json", R"({"name": "com.acme.own", "version": "1.0.0"})");
  write("Packages/com.acme.own/Twice.hlsl", "float Twice(float x) { return 2.0 * x; }\n");
  write("Assets/Good.hlsl",
        "#include \"Packages/com.acme.fx/Half.hlsl\"\n#include \"Packages/com.acme.own/Twice.hlsl\"\n"
        "#if UNITY != 202135\n#error another version\n#endif\n"
        "float4 Main(float2 uv : TEXCOORD0) : SV_Target { return Twice(Half(uv.x)); }\n");
  git("git add .");
  for (const char* arguments : {"--project . -- Assets/Good.hlsl", "-- Assets/Good.hlsl"}) {
    const auto result = hook(arguments);
    EXPECT_EQ(result.exit_code, 0) << arguments << '\n' << result.output << result.errors;
  }
}

TEST_F(PreCommit, AFilesNameIsNoOption) {
  write("--output=taken.hlsl", read("Assets/Good.hlsl"));
  git("git add .");
  const auto result = hook("-- --output=taken.hlsl");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(path("taken.hlsl")));
  EXPECT_THAT(result.output, HasSubstr("1 variant"));
}

TEST_F(PreCommit, WithoutFilesItTakesTheShadersOfTheCommit) {
  write("Assets/Old.shader", "Shader \"Old\" {}\n");
  git("git add . && git commit -q -m first");
  write("Assets/a b.shader", "Shader \"New\" {}\n");
  write("Assets/Kernel.compute", "#pragma kernel Main\n");
  write("Assets/Unstaged.shader", "Shader \"Unstaged\" {}\n");
  write("Assets/Good.hlsl", "// changed\n");
  git("git add 'Assets/a b.shader' Assets/Kernel.compute Assets/Good.hlsl");
  EXPECT_EQ(hook("--jobs 1", stub_program(0).string()).exit_code, 0);
  EXPECT_EQ(read("called"), "validate\n--jobs\n1\n--\nAssets/Kernel.compute\nAssets/a b.shader\n");
}

TEST_F(PreCommit, StopsACommitThatGitMakes) {
  write(".git/hooks/pre-commit",
        "#!/bin/sh\nexec '" + repository + "/ci/pre-commit' -- Assets/Broken.hlsl\n");
  git("chmod +x .git/hooks/pre-commit && git add .");
  const std::vector<std::string> program{std::string("PENUMBRA=") + PENUMBRA_PROGRAM};
  EXPECT_NE(run_in_project("git commit -m broken", program).exit_code, 0);
  EXPECT_NE(run_in_project("git rev-parse -q --verify HEAD").exit_code, 0);
  write("Assets/Broken.hlsl", read("Assets/Good.hlsl"));
  const auto mended = run_in_project("git commit -q -a -m mended", program);
  EXPECT_EQ(mended.exit_code, 0) << mended.errors << mended.output;
}

TEST_F(PreCommit, NothingToValidateIsSuccessEvenWithoutAProgram) {
  EXPECT_EQ(hook("", "/no/such/penumbra").exit_code, 0);
  const auto missing = run_in_project("'" + repository + "/ci/pre-commit' -- Assets/Good.hlsl");
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_THAT(missing.errors, HasSubstr("not on PATH"));
}

TEST(PreCommitHooks, NameAScriptThatIsThereAndTheFilesWithEntryPoints) {
  const YAML::Node hook = YAML::LoadFile(repository + "/.pre-commit-hooks.yaml")[0];
  EXPECT_EQ(hook["language"].as<std::string>(), "script");
  EXPECT_TRUE(std::filesystem::exists(repository + "/" + hook["entry"].as<std::string>()));
  EXPECT_EQ(hook["args"].as<std::vector<std::string>>().back(), "--") << "files follow";
  const std::regex files(hook["files"].as<std::string>());
  EXPECT_TRUE(std::regex_search("Assets/Water.shader", files));
  EXPECT_TRUE(std::regex_search("Assets/Kernel.compute", files));
  EXPECT_FALSE(std::regex_search("Assets/Water.hlsl", files));
  EXPECT_FALSE(std::regex_search("Assets/Water.shader.meta", files));
}

}  // namespace
}  // namespace penumbra::ci
