// The program is ended in the middle: the old file survives, and what was finished is kept.
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::HasSubstr;

class Interrupted : public ProgramTest {};

// The kernel ends the program with SIGXFSZ in the very write that passes one KiB.
TEST_F(Interrupted, KilledInsideAWriteKeepsTheOldFile) {
  write("out.json", "old");
  const auto result =
      shell("ulimit -f 1; " PENUMBRA_PROGRAM " tables --format json -o " + path("out.json").string());
  EXPECT_NE(result.exit_code, 0);
  EXPECT_EQ(read("out.json"), "old");
}

// The command is interrupted as soon as the first light's reference is kept.
TEST_F(Interrupted, MeasureStopsCleanlyAndKeepsWhatWasFinished) {
  const std::string kept = path("cache").string() + "/reference";
  const auto stopped =
      shell("export PENUMBRA_CACHE=" + path("cache").string() +
            "; " PENUMBRA_PROGRAM
            " measure --scene contact-boxes --light 2,5 --technique tent-5 --size 160x90"
            " --map-size 512 --seeds 1 --reference-samples 65536 -o " +
            path("out").string() + " & program=$!; while kill -0 $program && [ -z \"$(ls " + kept +
            " 2>/dev/null)\" ]; do sleep 0.1; done; kill -INT $program; wait $program");
  EXPECT_EQ(stopped.exit_code, 130) << stopped.errors;
  EXPECT_THAT(stopped.errors, HasSubstr("interrupted"));
  EXPECT_FALSE(std::filesystem::exists(path("out") / "results.json"));
  EXPECT_FALSE(std::filesystem::exists(path("out") / "report.html"));
  EXPECT_FALSE(std::filesystem::is_empty(kept));
}

}  // namespace
}  // namespace penumbra
