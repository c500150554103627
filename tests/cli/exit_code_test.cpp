#include <csignal>

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
  for (const char* code : {"  0 ", "  1 ", "  2 ", "  3 ", "  70 ", "  130 ", "  143 "})
    EXPECT_THAT(help.output, HasSubstr(code));
}

// A full disk: what was asked for is lost, which a script must be able to see.
TEST_F(ExitCode, OutputThatCannotBeWrittenIsTwo) {
  for (const char* asked : {"--help", "--version", "", "measure --help", "tables"}) {
    const auto result = shell(std::string(PENUMBRA_PROGRAM " ") + asked + " >/dev/full");
    EXPECT_EQ(result.exit_code, 2) << asked;
    EXPECT_THAT(result.errors, HasSubstr("standard output: cannot be written")) << asked;
  }
}

// Notes find no place, either.
TEST_F(ExitCode, OneFullFileForOutputAndNotesIsTwo) {
  const auto result = shell(PENUMBRA_PROGRAM
                            " measure --scene contact-boxes --technique hard --size 32x32 --light 2 --seeds 1"
                            " --reference-samples 32 --timing-repeats 0 >/dev/full 2>&1");
  EXPECT_EQ(result.exit_code, 2);
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

// Waits until $program handles the signal; ends if it has ended before.
std::string until_it_takes(int signal) {
  return "handled() { (( 0x$(sed -n 's/^SigCgt:\\s*//p' /proc/$program/status) >> " +
         std::to_string(signal - 1) +
         " & 1 )); }\n"
         "while kill -0 $program 2>/dev/null && ! handled; do sleep 0.05; done\n";
}

// The program is ended by SIGINT once it listens for it, while it renders: the code is the shell's 128 + 2,
// and there is no half sheet.
TEST_F(ExitCode, AnInterruptionIs130) {
  const auto result =
      shell(PENUMBRA_PROGRAM " render --size 1920x1080 --reference-samples 65536 --scene trees --cache " +
            path("cache").string() + " --sheet " + path("sheet.png").string() + " & program=$!\n" +
            until_it_takes(SIGINT) + "kill -INT $program; wait $program");
  EXPECT_EQ(result.exit_code, 130) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("interrupted"));
  EXPECT_FALSE(std::filesystem::exists(path("sheet.png")));
}

// timeout(1) sends its signal to the program and then to the program's group.
TEST_F(ExitCode, ASignalThatIsSentTwiceAtOnceIsOneInterruption) {
  const auto result = shell(
      PENUMBRA_PROGRAM " render --quiet --size 1920x1080 --reference-samples 65536 --scene trees --cache " +
      path("cache").string() + " --sheet " + path("sheet.png").string() + " & program=$!\n" +
      until_it_takes(SIGTERM) + "for i in 1 2 3; do kill -TERM $program; done; wait $program");
  EXPECT_EQ(result.exit_code, 143) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("interrupted"));
}

// The reference is kept once it is traced; the function that comes after it takes minutes in one dispatch.
TEST_F(ExitCode, TerminationWithinADispatchIs143AndSoon) {
  const std::string slow = write("Slow.hlsl", R"(#include "Platform/Platform.hlsl"
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) {
  float x = pixel.x * 0.001;
  for (uint i = 0; i < 60000u; ++i) {
    [unroll] for (uint j = 0; j < 64u; ++j) x = frac(sin(x) * 43758.5);
  }
  return x;
}
)")
                               .string();
  const std::string cache = path("cache").string();
  const auto result =
      shell(PENUMBRA_PROGRAM
            " measure --quiet --scene slabs --light 2 --size 960x540 --map-size 512"
            " --reference-samples 32 --seeds 1 --timing-repeats 0 --no-split --adapter slow=" +
            slow + " --cache " + cache + " -o " + path("out").string() +
            " & program=$!; while kill -0 $program && [ -z \"$(find " + cache +
            " -type f 2>/dev/null)\" ]; do sleep 0.1; done; sleep 3; begin=$SECONDS; kill -TERM $program; "
            "wait $program; code=$?; [ $((SECONDS - begin)) -lt 20 ] && echo soon; exit $code");
  EXPECT_EQ(result.exit_code, 143) << result.errors;
  EXPECT_EQ(result.output, "soon\n");
  EXPECT_THAT(result.errors, HasSubstr("interrupted"));
  EXPECT_FALSE(std::filesystem::exists(path("out") / "results.json"));
}

TEST_F(ExitCode, MakingDisksStopsToo) {
  const auto result =
      shell(PENUMBRA_PROGRAM " tables --generate -o " + path("disks.txt").string() + " & program=$!\n" +
            until_it_takes(SIGTERM) + "kill -TERM $program; wait $program");
  EXPECT_EQ(result.exit_code, 143) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("interrupted"));
  EXPECT_THAT(listing(), IsEmpty());
}

}  // namespace
}  // namespace penumbra
