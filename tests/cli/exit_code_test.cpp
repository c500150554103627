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
}

TEST_F(ExitCode, BadUsageIsTwo) {
  EXPECT_EQ(run({}).exit_code, 2);
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

}  // namespace
}  // namespace penumbra
