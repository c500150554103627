// Projects and names are made to mislead or to hang: what is printed stays one message, and an end comes.
#include <sys/stat.h>

#include "cli/program.h"

namespace penumbra {
namespace {

using testing::AllOf;

using testing::HasSubstr;
using testing::Not;

constexpr const char* kWhite = "float4 Main() : SV_Target { return 1; }\n";

class UntrustedProject : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("P/Assets/Main.hlsl", kWhite);
    write("P/Assets/Main.shader",
          "Shader \"Main\" { SubShader { Pass { HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
          "float4 V(float4 p : POSITION) : SV_Position { return p; }\n"
          "float4 F() : SV_Target { return 1; }\nENDHLSL } } }\n");
  }
  platform::ChildResult validate(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"validate",   "--project", path("P").string(),
                                 "--no-cache", "--target",  "spirv"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
};

TEST_F(UntrustedProject, NamesOfAManifestAreNoCommandsOfGitHub) {
  write("P/Packages/manifest.json",
        "{\"dependencies\": {\"com.a\\n::error file=x::taken\": \"1.0.0\", \"com.b\": "
        "\"file:..\\n::error::taken\"}}");
  for (const char* form : {"text", "github"}) {
    const auto result = validate({"--format", form});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr("com.a\\n::error file=x::taken"));
    EXPECT_THAT("\n" + result.errors + result.output, Not(HasSubstr("\n::error")));
  }
}

TEST_F(UntrustedProject, TextOfAShaderDoesNotMoveTheTerminal) {
  write("P/Assets/Main.hlsl", "float4 Main() : SV_Target { return \x1B]0;taken\x07\x1B[2J; }\n");
  const auto result = validate({path("P/Assets/Main.hlsl").string()});
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_THAT(result.output, AllOf(HasSubstr("Main.hlsl:1:"), HasSubstr("\\x1B]0;taken\\x07\\x1B[2J"),
                                   Not(HasSubstr("\x1B"))));
}

TEST_F(UntrustedProject, AManifestThatIsAPipeOrEndlessIsRefused) {
  std::filesystem::create_directories(path("P/Packages"));
  ASSERT_EQ(::mkfifo(path("P/Packages/manifest.json").c_str(), 0600), 0);
  const auto pipe = validate();
  EXPECT_EQ(pipe.exit_code, 2);
  EXPECT_THAT(pipe.errors, HasSubstr("manifest.json: is a device or a pipe"));
  std::filesystem::remove(path("P/Packages/manifest.json"));
  std::filesystem::create_symlink("/dev/zero", path("P/Packages/manifest.json"));
  EXPECT_EQ(validate().exit_code, 2);
}

TEST_F(UntrustedProject, APathThatNoLineDirectiveCanNameIsRefused) {
  for (const std::string name : {"P/Assets/a\"b.hlsl", "P/Assets/a\n::error::b.hlsl"}) {
    const std::string file = write(name, kWhite).string();
    const auto result = validate({file});
    EXPECT_NE(result.exit_code, 0);
    EXPECT_THAT(result.errors + result.output, HasSubstr("rename it"));
    EXPECT_THAT("\n" + result.errors + result.output, Not(HasSubstr("\n::error")));
    write("P/Assets/Main.hlsl",
          "#include \"" + std::filesystem::path(file).filename().string() + "\"\n" + kWhite);
    EXPECT_EQ(validate({path("P/Assets/Main.hlsl").string()}).exit_code, 1);
  }
}

// The other files are checked, and the folder is an error of the report.
TEST_F(UntrustedProject, AFileInAFolderThatCannotBeReadIsReportedBesideTheOthers) {
  const std::string shader =
      "Shader \"T\" { SubShader { Pass { HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
      "float4 V() : SV_Position { return 1; }\nfloat4 F() : SV_Target { return 1; }\nENDHLSL\n} } }\n";
  write("P/Assets/Good.shader", shader);
  write("P/Assets/Bad\"name.shader", shader);
  const auto result = run({"validate", path("P/Assets").string(), "--no-cache", "--target", "spirv"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output,
              HasSubstrs("Bad\"name.shader: error: cannot be read: its path holds a quotation mark",
                         "4 variants for 1 target: 5 results"));
}

TEST_F(UntrustedProject, AKeyOfMegabytesIsNotEchoed) {
  const auto config = write("c.json", "{\"" + std::string(10'000'000, 'k') + "\": 1}");
  const auto result = run({"constants", "--config", config.string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstrs("c.json:1:2: unknown key 'kkk", "bytes left out"));
  EXPECT_LT(result.errors.size(), 6000u);
}

// Four bytes of a file become a hundred of memory.
TEST_F(UntrustedProject, OutOfMemoryIsAnAnswer) {
  std::string text = "[";
  for (int i = 0; i < 2'000'000; ++i) text += "10,";
  const std::string command =
      std::string(PENUMBRA_PROGRAM) + " constants --config " + write("c.json", text + "1]").string();
  for (const char* kilobytes : {"170000", "200000", "230000"}) {
    const auto result = shell("ulimit -v " + std::string(kilobytes) + "; " + command);
    EXPECT_EQ(result.exit_code, 3) << kilobytes;
    EXPECT_THAT(result.errors, HasSubstr("penumbra: out of memory")) << kilobytes;
  }
  EXPECT_EQ(shell(command).exit_code, 2) << "with memory enough: not what is expected";
}

// /proc takes no new files, from root neither.
TEST_F(UntrustedProject, WithoutAFolderForTheCacheTheRestWorks) {
  const std::string command =
      std::string(PENUMBRA_PROGRAM) + " validate " + path("P/Assets/Main.hlsl").string() + " --target spirv";
  for (const std::string& variables :
       {std::string("-u PENUMBRA_CACHE -u XDG_CACHE_HOME HOME=/proc/none"),
        std::string("PENUMBRA_CACHE=/proc/none"),
        "-u PENUMBRA_CACHE -u XDG_CACHE_HOME HOME=" + write("file", "").string()}) {
    const auto result = shell("env " + variables + " " + command);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.errors, HasSubstrs("note: nothing is kept for the next run", "PENUMBRA_CACHE"));
    EXPECT_THAT(shell("env " + variables + " " + command + " --quiet").errors, "");
  }
  const auto without_temporary =
      shell("env -u HOME -u PENUMBRA_CACHE -u XDG_CACHE_HOME TMPDIR=/proc/none " + command);
  EXPECT_EQ(without_temporary.exit_code, 0) << without_temporary.errors;
  const auto taken = run({"validate", path("P/Assets/Main.hlsl").string(), "--cache", path("file").string()});
  EXPECT_EQ(taken.exit_code, 2) << "the user has named a file";
}

TEST_F(UntrustedProject, ARelativeFolderForCachesIsNotUsed) {
  std::filesystem::create_directories(path("home"));
  const auto result =
      shell("cd " + path("").string() +
            " && env -u PENUMBRA_CACHE XDG_CACHE_HOME=relative HOME=" + path("home").string() + " " +
            std::string(PENUMBRA_PROGRAM) + " validate P/Assets/Main.hlsl --target spirv");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(path("relative")));
  EXPECT_TRUE(std::filesystem::exists(path("home/.cache/penumbra")));
}

TEST_F(UntrustedProject, MeasuringWorksWithoutAFolderForTheCache) {
  const auto result = shell("env PENUMBRA_CACHE=/proc/none " + std::string(PENUMBRA_PROGRAM) +
                            " measure --scene contact-boxes --technique hard --light 2 --size 32x18 "
                            "--reference-samples 32 --seeds 1 -o " +
                            path("out").string());
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("note: nothing is kept for the next run"));
  EXPECT_TRUE(std::filesystem::exists(path("out/results.json")));
}

}  // namespace
}  // namespace penumbra
