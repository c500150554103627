// A study that has been measured is not lost where its report cannot be written.
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::HasSubstr;

class FinishedStudy : public ProgramTest {
 protected:
  std::string command() const {
    return std::string(PENUMBRA_PROGRAM) +
           " measure --scene contact-boxes --light 2 --size 64x36 --map-size 256 --seeds 1 "
           "--reference-samples 32"
           " --timing-repeats 0 --no-split --technique tent-5,hard --cache " +
           path("cache").string() + " -o " + path("out").string();
  }

  // The last record of the command takes long enough for something to happen before it is there.
  std::string slow_command() const {
    return command() + " --adapter slow=" +
           write("slow.hlsl",
                 "float ShadowVisibility(float3 p, float3 n, float2 x)\n"
                 "{\n"
                 "    float s = x.x;\n"
                 "    [loop] for (int i = 0; i < 20000; ++i) s = frac(sin(s) * 43758.5);\n"
                 "    return saturate(s);\n"
                 "}\n")
               .string();
  }

  std::size_t kept() const {
    std::size_t count = 0;
    if (!std::filesystem::exists(path("cache"))) return 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path("cache")))
      count += entry.path().extension() == ".record";
    return count;
  }
};

TEST_F(FinishedStudy, IsDrawnWhateverItsTitlesAre) {
  const auto result = shell(command() + R"( --title "tent-5='Soft' ''tent''" --title 'hard="a\b `id`"')");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(kept(), 0U);
  EXPECT_THAT(read("out/pareto-fetches.svg"),
              HasSubstrs("&#39;Soft&#39; &#39;&#39;tent&#39;&#39;", R"(a\b `id`)"));
}

TEST_F(FinishedStudy, IsNotBegunWhereItsFilesCannotBe) {
  for (const char* name : {"report.html", "results.json", "pareto-fetches.svg", "pictures"}) {
    ASSERT_EQ(
        shell("mkdir " + path("out").string() + " && mkfifo " + path("out").string() + "/" + name).exit_code,
        0);
    const auto result = shell(command());
    EXPECT_EQ(result.exit_code, 2) << name;
    EXPECT_THAT(result.errors, HasSubstrs(name, "of the report")) << name;
    EXPECT_FALSE(std::filesystem::exists(path("cache"))) << "it began";
    std::filesystem::remove_all(path("out"));
  }
  write("out/.git", "a checkout, which brings links");
  std::filesystem::create_directory(path("elsewhere"));
  std::filesystem::create_directory_symlink(path("elsewhere"), path("out/pictures"));
  const auto linked = shell(command());
  EXPECT_EQ(linked.exit_code, 2);
  EXPECT_THAT(linked.errors, HasSubstr("is a link, which is not followed"));
  EXPECT_FALSE(std::filesystem::exists(path("cache"))) << "it began";
}

// A folder in the place of a picture appears while the study runs. The results are there, and the next run
// has nothing to measure.
TEST_F(FinishedStudy, IsKeptUntilItsReportIsWritten) {
  write("out/pareto-fetches.svg", "of an earlier run");
  write("out/pictures/box.png", "of an earlier run");
  const auto failed =
      shell(slow_command() + " & program=$!; while kill -0 $program && [ -z \"$(find " +
            path("cache").string() + " -name '*.record' 2>/dev/null)\" ]; do sleep 0.01; done; mkdir -p " +
            path("out/report.html").string() + "; wait $program");
  EXPECT_EQ(failed.exit_code, 2) << failed.errors;
  EXPECT_THAT(failed.errors,
              HasSubstrs("report.html", "what was measured is kept; the same command goes on from there"));
  EXPECT_THAT(read("out/results.json"), HasSubstr("\"technique\": \"hard\""));
  EXPECT_FALSE(std::filesystem::exists(path("out/pareto-fetches.svg"))) << "of other results";
  EXPECT_FALSE(std::filesystem::exists(path("out/pictures/box.png"))) << "of other results";
  EXPECT_EQ(kept(), 3U);
  std::filesystem::remove(path("out/report.html"));
  const std::string results = read("out/results.json");
  EXPECT_EQ(shell(slow_command()).exit_code, 0);
  EXPECT_EQ(read("out/results.json"), results);
  EXPECT_EQ(kept(), 0U);
}

// Neither the report nor the records fit.
TEST_F(FinishedStudy, SaysWhenItCouldNotBeKept) {
  const auto failed = shell("ulimit -f 4; " + command());
  EXPECT_EQ(failed.exit_code, 2) << failed.errors;
  EXPECT_THAT(failed.errors, HasSubstr("the cache could not keep all that was measured"));
  EXPECT_LT(kept(), 2U);
}

// The first run traces its reference and loads what that needs; the second finds the reference. Records that
// it did not find would stay.
TEST_F(FinishedStudy, GoesOnFromARunThatBeganWithAnEmptyCache) {
  const std::string whole = slow_command();
  const auto stopped =
      shell(whole + " & program=$!; while kill -0 $program && [ -z \"$(find " + path("cache").string() +
            " -name '*.record' 2>/dev/null)\" ]; do sleep 0.01; done; kill -INT $program; "
            "wait $program");
  ASSERT_EQ(stopped.exit_code, 130) << stopped.errors;
  ASSERT_GE(kept(), 1U);
  EXPECT_EQ(shell(whole).exit_code, 0);
  EXPECT_EQ(kept(), 0U);
}

}  // namespace
}  // namespace penumbra
