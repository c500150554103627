// Ended in the middle: the old file survives, and long work goes on where it stopped.
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

TEST_F(Interrupted, MeasureStopsCleanlyAndGoesOnWhereItStopped) {
  const std::string command = "PENUMBRA_CACHE=" + path("cache").string() +
                              " timeout --preserve-status --signal=INT SECONDS " PENUMBRA_PROGRAM
                              " measure --scene contact-boxes --light 2 --technique tent-5 --size 160x90"
                              " --map-size 512 --seeds 1 --reference-samples 65536 -o " +
                              path("out").string();
  const auto with_seconds = [&](const std::string& seconds) {
    std::string text = command;
    return text.replace(text.find("SECONDS"), 7, seconds);
  };
  const auto stopped = shell(with_seconds("4"));
  EXPECT_EQ(stopped.exit_code, 130) << stopped.errors;
  EXPECT_THAT(stopped.errors, HasSubstr("interrupted"));
  EXPECT_FALSE(std::filesystem::exists(path("out") / "results.json"));
  EXPECT_FALSE(std::filesystem::exists(path("out") / "report.html"));
  EXPECT_FALSE(std::filesystem::is_empty(path("cache")));
}

}  // namespace
}  // namespace penumbra
