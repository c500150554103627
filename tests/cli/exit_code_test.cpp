#include "cli/program.h"

namespace penumbra {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class ExitCode : public ProgramTest {};

TEST_F(ExitCode, HelpAndVersionAreSuccess) {
  const auto help = run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* name : {"constants", "tables", "validate", "merge", "cost", "render", "measure"}) {
    EXPECT_THAT(help.output, HasSubstr(name));
  }
  EXPECT_EQ(run({"--version"}).exit_code, 0);
  for (const char* code : {"  0 ", "  1 ", "  2 ", "  3 ", "  70 ", "  130 "})
    EXPECT_THAT(help.output, HasSubstr(code));
}

TEST_F(ExitCode, BadUsageIsTwo) {
  EXPECT_EQ(run({"nonsense"}).exit_code, 2);
  EXPECT_EQ(run({"constants", "--no-such-option"}).exit_code, 2);
}

TEST_F(ExitCode, AMissingDeviceIsThreeAndNamesThoseThereAre) {
  const auto result = run({"measure", "--scene", "contact-boxes", "--device", "no such device"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.errors, HasSubstr("llvmpipe"));
}

TEST_F(ExitCode, AFailingVariantIsAFindingAndOne) {
  const auto file = write("broken.hlsl", "[numthreads(1, 1, 1)] void Main() { undeclared = 1; }\n");
  const auto result = run({"validate", file.string(), "--entry", "Main", "--stage", "compute"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output + result.errors, HasSubstr("broken.hlsl:1:"));
}

TEST_F(ExitCode, ConstantsAnswerWithoutAnyInput) {
  const auto result = run({"constants", "--format", "json"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("\"depth_to_radial\""));
  EXPECT_THAT(result.errors, IsEmpty());
}

TEST_F(ExitCode, TheSameCommandGivesTheSameBytes) {
  const std::vector<std::string> command{"tables", "--format", "json"};
  EXPECT_EQ(run(command).output, run(command).output);
}

// Ended by SIGINT, once it listens for it, while it renders: the shell's 128 + 2, and no half sheet.
TEST_F(ExitCode, AnInterruptionIs130) {
  const auto result =
      shell(PENUMBRA_PROGRAM " render --size 1920x1080 --reference-samples 65536 --scene trees --cache " +
            path("cache").string() + " --sheet " + path("sheet.png").string() +
            " & listens() { (( 0x$(sed -n 's/^SigCgt:\\s*//p' /proc/$!/status) & 2 )); }\n"
            "until listens; do sleep 0.05; done; kill -INT $!; wait $!");
  EXPECT_EQ(result.exit_code, 130) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("interrupted"));
  EXPECT_FALSE(std::filesystem::exists(path("sheet.png")));
}

// timeout(1) sends its signal to the program and then to the program's group.
TEST_F(ExitCode, ASignalThatIsSentTwiceAtOnceIsOneInterruption) {
  const auto result = shell(
      PENUMBRA_PROGRAM " render --quiet --size 1920x1080 --reference-samples 65536 --scene trees --cache " +
      path("cache").string() + " --sheet " + path("sheet.png").string() +
      " & listens() { (( 0x$(sed -n 's/^SigCgt:\\s*//p' /proc/$!/status) & 2 )); }\n"
      "until listens; do sleep 0.05; done; for i in 1 2 3; do kill -TERM $!; done; wait $!");
  EXPECT_EQ(result.exit_code, 130) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("interrupted"));
}

}  // namespace
}  // namespace penumbra
