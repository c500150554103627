// penumbra measure --from takes what penumbra measure has written; and each technique runs at its settings.
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace penumbra {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class MeasureFrom : public ProgramTest {
 protected:
  static Words small(const Words& options) {
    return words(
        "measure --quiet --size 32x18 --reference-samples 32 --seeds 1 --map-size 512 "
        "--timing-repeats 0 --no-split",
        options);
  }

  Json measured(const std::vector<std::string>& options) {
    const auto result = expect_success(small(options));
    const std::filesystem::path file = write("results.json", result.output);
    const auto again = expect_success({"measure", "--from", file.string()});
    EXPECT_EQ(again.output, result.output);
    return Json::parse(result.output);
  }
};

TEST_F(MeasureFrom, WhatIsAskedForTwiceIsMeasuredOnceAndReadAgain) {
  const Json results = measured({"--scene", "slabs", "--scene", "slabs", "--light", "2", "--light", "2",
                                 "--technique", "hard", "--technique", "tent-5", "--technique", "hard"});
  ASSERT_EQ(results["records"].size(), 2U);
  EXPECT_EQ(results["frames"].size(), 1U);
}

TEST_F(MeasureFrom, ABakesOptionIsRefusedWhereNoTechniqueReadsIt) {
  const auto refused = [&](const std::string& technique, const std::string& option) {
    expect_bad_input(small({"--scene", "slabs", "--technique", technique, option, "64"}),
                     testing::HasSubstr(option + " has no effect on techniques that read no"));
  };
  for (const char* option : {"--ground-samples", "--horizon-texels", "--field-voxels"})
    refused("hard", option);
  refused("pcss-angular-24-16-far-heights", "--horizon-texels");
  refused("pcss-angular-24-16-far-horizon", "--field-voxels");
  // The test shows what a technique reads, and what its bake is made of. The run ends at a device that is not
  // there.
  const auto taken = [&](const std::string& technique, const std::string& option) {
    const auto result = run(small(
        {"--scene", "slabs", "--technique", technique, option, "64", "--device", "no device has this name"}));
    EXPECT_NE(result.exit_code, 0);
    EXPECT_THAT(result.errors, testing::AllOf(HasSubstr("no device has this name"),
                                              testing::Not(HasSubstr("has no effect"))));
  };
  taken("hard,pcss-angular-24-16-far-heights", "--ground-samples");
  taken("pcss-angular-24-16-far-horizon", "--ground-samples");
  taken("pcss-angular-24-16-far-horizon,pcss-angular-24-16-far-heights", "--horizon-texels");
  taken("distance-field-soft", "--field-voxels");
}

TEST_F(MeasureFrom, AReportOfEarlierFiguresHasNoFolderForPictures) {
  measured({"--scene", "slabs", "--light", "2", "--technique", "hard"});
  const auto again =
      expect_success({"measure", "--from", path("results.json").string(), "-o", path("again").string()});
  EXPECT_TRUE(std::filesystem::exists(path("again/report.html")));
  EXPECT_FALSE(std::filesystem::exists(path("again/pictures")));
}

TEST_F(MeasureFrom, ARecordSaysWhatItRanAt) {
  const std::string lit = write("Lit.hlsl", R"(#include "Platform/Platform.hlsl"
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel) { return 1.0; }
)")
                              .string();
  const Json results =
      measured({"--scene", "slabs", "--light", "2", "--technique", "tent-7", "--technique",
                "pcss-angular-24-16", "--adapter", "plain=" + lit, "--adapter",
                "told=" + lit + ";@depth-bias=2;@normal-bias=0.5;@soft-quality=low;@light-scale=0.5"});
  const Json& records = results["records"];
  EXPECT_EQ(records[0]["settings"]["normal_bias"], 1.0);
  EXPECT_EQ(records[0]["settings"]["soft_quality"], "high");
  EXPECT_EQ(records[1]["settings"]["normal_bias"], 0.0);
  EXPECT_EQ(records[2]["settings"]["normal_bias"], 1.0);
  EXPECT_EQ(records[3]["settings"]["depth_bias"], 2.0);
  EXPECT_EQ(records[3]["settings"]["normal_bias"], 0.5);
  EXPECT_EQ(records[3]["settings"]["soft_quality"], "low");
  EXPECT_EQ(records[3]["settings"]["light_scale"], 0.5);
  EXPECT_EQ(records[3]["settings"]["slope_bias"], 2.5);
  EXPECT_EQ(results["frames"][0]["width"], 32);
}

TEST_F(MeasureFrom, OneBiasForAllWhereItIsAskedFor) {
  const Json results = measured({"--scene", "slabs", "--light", "2", "--technique", "tent-7", "--technique",
                                 "pcss-angular-24-16", "--normal-bias", "0.25", "--soft-quality", "low"});
  for (const Json& record : results["records"]) {
    EXPECT_EQ(record["settings"]["normal_bias"], 0.25);
    EXPECT_EQ(record["settings"]["soft_quality"], "low");
  }
}

TEST_F(MeasureFrom, PicturesGrowUntilTheyHoldEnoughPenumbra) {
  const Json small_picture = measured({"--scene", "slabs", "--light", "2", "--technique", "hard"});
  const int found = small_picture["records"][0]["penumbra_pixels"];
  ASSERT_GT(found, 0);
  const std::string wanted = std::to_string(5 * found);
  const Json large =
      measured({"--scene", "slabs", "--light", "2", "--technique", "hard", "--penumbra-pixels", wanted});
  EXPECT_GE(large["records"][0]["penumbra_pixels"], 5 * found);
  EXPECT_GT(large["frames"][0]["width"], 32);
  EXPECT_LE(large["frames"][0]["width"], 128);
}

TEST_F(MeasureFrom, TitlesStandInRecordsAndInTheCommand) {
  const auto measured =
      expect_success(small({"--scene", "slabs", "--light", "2", "--technique", "hard,tent-5", "--title",
                            "hard=No filter", "--title", "tent-5=The tent's"}));
  EXPECT_THAT(measured.output, HasSubstr("--title 'hard=No filter'"));
  EXPECT_THAT(Json::parse(measured.output)["command"].get<std::string>(),
              HasSubstr("--title 'tent-5=The tent'\\''s'"));
  const Json records = Json::parse(measured.output)["records"];
  EXPECT_EQ(records[0]["title"], "No filter");
  EXPECT_EQ(records[1]["title"], "The tent's");
}

TEST_F(MeasureFrom, AnUnknownSettingOfAnAdapterIsNamed) {
  const platform::ChildResult result =
      run({"measure", "--scene", "slabs", "--adapter", "mine=Shadow.hlsl;@normal-bais=1"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstrs("@normal-bais", "@normal-bias"));
  EXPECT_THAT(run({"measure", "--scene", "slabs", "--adapter", "mine=Shadow.hlsl;@depth-bias=99"}).errors,
              HasSubstr("from 0 to 10"));
}

}  // namespace
}  // namespace penumbra
