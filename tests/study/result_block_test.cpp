#include "study/result_block.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "input/input_error_matcher.h"
#include "study/summary.h"
#include "study/synthetic_study.h"

namespace penumbra::study {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kChart = "Documentation~/results/pareto-fetches.svg";

TEST(ResultBlock, ErrorsOfEveryLightThenChartCostsAndOrigin) {
  const std::string block = result_block(synthetic::results(), {kChart, {}});
  const std::vector<std::string> order{
      "0.53° light, 2 scenes, 18000 penumbra pixels, at least 9000 per scene;",
      "2° light, 2 scenes",
      "| Technique | RMSE in penumbra, 0.53° | RMSE in penumbra, 2° | light leaks, %, 0.53° | light leaks, "
      "%, "
      "2° | false shadow, %, 0.53° | false shadow, %, 2° |",
      "](Documentation~/results/pareto-fetches.svg)",
      "| Technique | RMSE of all pixels, 0.53° | RMSE of all pixels, 2° | grain, 0.53° | grain, 2° | "
      "fetches per pixel, 0.53° | fetches per pixel, 2° | fetches in penumbrae, 2° |\n",
      "penumbra measure --seed 1",
      "com.example.shadows 17.0.3, com.example.core,",
      "made-up driver 1.2",
      "made-up processor"};
  std::size_t last = 0;
  for (const std::string& part : order) {
    const std::size_t at = block.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    EXPECT_GT(at, last) << part;
    last = at;
  }
}

TEST(ResultBlock, OneSceneSaysNothingOfOthers) {
  Results results = synthetic::results();
  const std::string scene = results.records.front().scene;
  std::erase_if(results.records, [&](const Record& record) { return record.scene != scene; });
  const std::string block = result_block(results, {kChart, {}});
  EXPECT_THAT(block, AllOf(HasSubstr("says nothing of other scenes"), Not(HasSubstr("choice of scenes"))));
  EXPECT_THAT(block, AllOf(HasSubstr("1 scene, 9000 penumbra pixels:"), Not(HasSubstr("at least"))));
  EXPECT_THAT(result_block(synthetic::results(), {kChart, {}}),
              HasSubstr("the choice of scenes and of pixels"));
}

TEST(ResultBlock, OperationsAreShownWhereOptimisedBytecodeRan) {
  Results results = synthetic::results();
  EXPECT_THAT(result_block(results, {kChart, {}}), Not(HasSubstr("perations")));
  for (Record& record : results.records) record.operations_per_pixel = 1234.4;
  EXPECT_THAT(result_block(results, {kChart, {}}),
              AllOf(Not(HasSubstr("perations")), HasSubstr("shaders compiled by glslang")));
  results.front_end = "FXC 10.0";
  EXPECT_THAT(result_block(results, {kChart, {}}),
              AllOf(HasSubstr("| operations per pixel, 0.53° | operations per pixel, 2° |"),
                    HasSubstr(" | 1234 | 1234 |\n"), HasSubstr("as FXC has optimised it"),
                    HasSubstr("shaders compiled by FXC 10.0")));
  EXPECT_THAT(result_block(results, {kChart, {}, BlockForm::brief}),
              AllOf(HasSubstr("| operations per pixel, 2° |\n"), Not(HasSubstr("fetches per pixel"))));
}

// The pass has 512 x 512 texels and 2 fetches in each of two cascades, in a picture of 480 x 270.
TEST(ResultBlock, PassesOverTheMapAreGivenApart) {
  Results results = synthetic::results();
  EXPECT_THAT(result_block(results, {kChart, {}}), Not(HasSubstr("passes over the map")));
  for (MeasuredFrame& frame : results.frames) {
    frame.width = 480;
    frame.height = 270;
  }
  const double per_cascade = 2.0 * 512 * 512;
  for (Record& record : results.records) {
    if (record.technique != "pcss-64-64") continue;
    record.cascades = 2;
    record.metrics.fetches_mean = 10.0;
    record.metrics.preprocess_fetches_per_pixel = 2.0 * per_cascade / (480 * 270);
    record.passes = {{"Blur", "cascade", record.metrics.preprocess_fetches_per_pixel, 0.0, per_cascade},
                     {"filter", "frame", 10.0, 0.0, std::nullopt}};
  }
  const std::string block = result_block(results, {kChart, {}});
  EXPECT_THAT(block, HasSubstr("divided by the pixels of the pictures, which are of 480 x 270 pixels."));
  EXPECT_THAT(block,
              HasSubstr("| fetches of the passes over the map, millions | other fetches per pixel |\n"));
  EXPECT_THAT(block, AllOf(HasSubstr("| 1.0 | 10.0 |\n"), HasSubstr("| – | – |\n")));
}

TEST(ResultBlock, ARowForEachTechniqueInTheFullForm) {
  FactsOfTechniques facts;
  facts.techniques["bilinear"].use_when = "one fetch | is all";
  facts.techniques["pcss-64-64"] = {"reference", "on phones", {}, ProgramCycles{5299.4, 1816.0}};
  facts.techniques["unmeasured"].use_when = "never";
  const BlockStyle style{kChart, {"pcss-64-64", "tent-5x5"}, BlockForm::full, facts};
  const std::string block = result_block(synthetic::results(), style);
  EXPECT_THAT(
      block,
      HasSubstr("| grain, 2° | fetches per pixel, 0.53° | fetches per pixel, 2° | fetches in penumbrae, 2° "
                "| maps, MiB | Use it when | Not when |\n"
                "|:--|--:|--:|--:|--:|--:|--:|--:|--:|:--|:--|\n| `pcss-64-64` | "));
  EXPECT_THAT(block, HasSubstr("| reference | on phones |\n| `tent-5x5` | "));
  EXPECT_THAT(block, Not(HasSubstr("one fetch")));
  EXPECT_THAT(block, Not(HasSubstr("5299"))) << "whose cycles is not said";
  facts.cycles_of = "RADV, navi21";
  EXPECT_THAT(result_block(synthetic::results(), {kChart, {"pcss-64-64"}, BlockForm::full, facts}),
              AllOf(HasSubstr("| cycles, RADV, navi21 |"), HasSubstr("| 5299 + 1816 | reference |")));
  EXPECT_THAT(result_block(synthetic::results(), {kChart, {"bilinear"}, BlockForm::full, facts}),
              HasSubstr("| – | one fetch \\| is all |  |\n"));
  for (const BlockForm form : {BlockForm::brief, BlockForm::line})
    EXPECT_THAT(result_block(synthetic::results(), {kChart, {}, form, facts}), Not(HasSubstr("on phones")));
  EXPECT_THAT(result_block(synthetic::results(), {kChart, {}}), Not(HasSubstr("Use it when")));
}

// The results come from a file that anybody may have written.
TEST(ResultBlock, WhatResultsHoldCannotEndTheBlock) {
  const std::string hostile = "--> <!-- results:end -->\n```\n| a | \x1B[2J";
  Results results = synthetic::results();
  results.command = hostile;
  results.device = results.driver = results.hardware = results.library_version = hostile;
  results.commit = hostile;
  for (Record& record : results.records) record.scene = record.technique = record.title = hostile;
  const std::string page = "<!-- results:begin --><!-- results:end -->rest";
  for (const BlockForm form : {BlockForm::full, BlockForm::brief, BlockForm::line}) {
    const std::string block = result_block(results, {kChart, {}, form});
    const std::string once = replace_result_block(page, block, "README.md");
    EXPECT_EQ(replace_result_block(once, block, "README.md"), once);
    EXPECT_EQ(block.find('\x1B'), std::string::npos);
    EXPECT_EQ(block.find("<!--"), std::string::npos);
  }
}

TEST(ResultBlock, TablesHoldMeans) {
  Results results = synthetic::results();
  results.records[0].metrics.rmse_penumbra = 0.2;    // boxes, bilinear, 0.53°
  results.records[8].metrics.rmse_penumbra = 0.125;  // fence, bilinear, 0.53°
  ASSERT_EQ(results.records[8].scene, "fence");
  results.records[0].metrics.intervals.rmse_penumbra = Interval{0.19, 0.22, 0.008};
  results.records[8].metrics.intervals.rmse_penumbra = Interval{0.12, 0.13, 0.0025};
  const std::string block = result_block(results, {kChart, {}});
  EXPECT_THAT(block, HasSubstr("Title of bilinear, `bilinear` | 0.2 [0, 0.6] | 0."));
  EXPECT_THAT(block, Not(HasSubstr(" ms"))) << "CPU time has no place in the README";
}

TEST(ResultBlock, RowsAreChosenAndOrdered) {
  const std::string block =
      result_block(synthetic::results(), {kChart, {"pcss-64-64", "nobody", "bilinear"}});
  EXPECT_LT(block.find("`pcss-64-64` |"), block.find("`bilinear` |"));
  EXPECT_THAT(block, Not(HasSubstr("tent-5x5")));
  expect_input_error(
      [] {
        (void)result_block(synthetic::results(), {kChart, {"nobody", "none"}});
      },
      HasSubstr("none of the rows nobody, none was measured"));
  expect_input_error(
      [] {
        (void)result_block(synthetic::results(), {kChart, {"bilinaer"}});
      },
      HasSubstr("did you mean 'bilinear'?"));
}

TEST(ResultBlock, ABriefOneIsATableOfAllLights) {
  const std::string block = result_block(synthetic::results(), {kChart, {}, BlockForm::brief});
  EXPECT_TRUE(block.starts_with("0.53° light, 2 scenes")) << block;
  EXPECT_THAT(block, HasSubstr("per scene; 2° light, 2 scenes"));
  EXPECT_THAT(
      block,
      HasSubstr("| false shadow, %, 2° | grain, 0.53° | grain, 2° | fetches per pixel, 0.53° | fetches per "
                "pixel, 2° |\n"));
  EXPECT_THAT(block, HasSubstr("\n| Title of bilinear | "));
  EXPECT_THAT(block, Not(HasSubstr(kChart)));
  EXPECT_THAT(block, Not(HasSubstr("| boxes |")));
  EXPECT_THAT(block, HasSubstr("Command: `penumbra measure --seed 1`"));
}

TEST(ResultBlock, GrainIsTheRootOfTheVarianceAndStandsWhereThereAreSeveralSeeds) {
  Results results = synthetic::results({"bilinear"});
  for (Record& record : results.records) record.metrics.variance = 0.0004;
  EXPECT_THAT(result_block(results, {kChart, {}, BlockForm::brief}), HasSubstr("| 0.020 | 0.020 |"));
  for (Record& record : results.records) record.metrics.variance.reset();
  for (const BlockForm form : {BlockForm::brief, BlockForm::full})
    EXPECT_THAT(result_block(results, {kChart, {}, form}), Not(HasSubstr("rain")));
}

TEST(ResultBlock, FlipAndOverlapsStandWhereTheyWereMeasured) {
  Results results = synthetic::results({"bilinear"});
  for (const BlockForm form : {BlockForm::brief, BlockForm::full})
    EXPECT_THAT(result_block(results, {kChart, {}, form}),
                AllOf(Not(HasSubstr("FLIP")), Not(HasSubstr("overlap"))));
  for (Record& record : results.records) {
    record.flip = 0.0125;
    record.overlap = OverlapRecord{100, 0.25, 0.0};
  }
  for (const BlockForm form : {BlockForm::brief, BlockForm::full})
    EXPECT_THAT(
        result_block(results, {kChart, {}, form}),
        AllOf(HasSubstr("| RMSE where shadows overlap, 2° |"), HasSubstr("| FLIP of the lit picture, 2° |"),
              HasSubstr("| 0.250 | 0.250 |"), HasSubstr("| 0.013 | 0.013 |")));
}

TEST(ResultBlock, StepsAcrossTilesAreMultiplesOfThoseInside) {
  Results results = synthetic::results({"bilinear"});
  EXPECT_THAT(result_block(results, {kChart, {}}), Not(HasSubstr("across tiles")));
  for (Record& record : results.records) record.group_step = GroupStep{1000, 0.03, 0.02};
  EXPECT_THAT(
      result_block(results, {kChart, {}}),
      AllOf(HasSubstr("| step across tiles, 0.53° | step across tiles, 2° |"), HasSubstr("| 1.50 | 1.50 |")));
  EXPECT_THAT(result_block(results, {kChart, {}, BlockForm::brief}), Not(HasSubstr("across tiles")));
  for (Record& record : results.records) record.group_step->inside = 0.0;
  EXPECT_THAT(result_block(results, {kChart, {}}), HasSubstr("| – | – |"));
}

TEST(ResultBlock, ABriefOneOfOneLightHasFetchesInPenumbrae) {
  Results results = synthetic::results();
  std::erase_if(results.records, [](const Record& record) { return record.light_degrees < 1.0; });
  EXPECT_THAT(
      result_block(results, {kChart, {}, BlockForm::brief}),
      HasSubstr("| Technique | RMSE in penumbra | RMSE of all pixels | light leaks, % | false shadow, % | "
                "fetches per pixel | fetches in penumbrae |\n"));
}

TEST(ResultBlock, TheLineIsOneSentenceOfTheMiddleLight) {
  const std::string line =
      result_block(synthetic::results(), {kChart, {"bilinear", "pcss-64-64"}, BlockForm::line});
  EXPECT_THAT(line, testing::StartsWith(
                        "Error in penumbrae (RMSE of visibility, 0 to 1, against ray tracing; 2° light, "
                        "mean of 2 scenes): Title of bilinear: 0."));
  EXPECT_THAT(line, HasSubstr("texture fetches per pixel ("));
  EXPECT_THAT(line, HasSubstr(" per pixel in penumbra); Title of pcss-64-64: 0."));
  EXPECT_EQ(line.find('\n'), line.size() - 1);
}

TEST(ResultBlock, AMapStandsBesideATitleWhereThereAreSeveral) {
  Results results = synthetic::results({"bilinear"});
  const std::size_t records = results.records.size();
  for (std::size_t i = 0; i < records; ++i) {
    results.records.push_back(results.records[i]);
    results.records.back().map_size = 1024;
  }
  EXPECT_THAT(result_block(results, {kChart, {}, BlockForm::brief}),
              testing::AllOf(HasSubstr("| Title of bilinear (2048 D32, 4 cascades) |"),
                             HasSubstr("| Title of bilinear (1024 D32, 4 cascades) |")));
}

TEST(ResultBlock, AMeanOverFewerScenesSaysSo) {
  Results results = synthetic::results();
  results.records.erase(results.records.begin());
  EXPECT_THAT(result_block(results, {kChart, {}}), HasSubstr("(1 scene)"));
}

TEST(ResultBlock, NamesCannotBreakTheTable) {
  Results results = synthetic::results({"a|b<c>\nd"});
  EXPECT_THAT(result_block(results, {kChart, {}}), HasSubstr("a\\|b&lt;c> d"));
}

TEST(ReplaceResultBlock, KeepsEverythingElse) {
  const std::string text = "# Title\n<!-- results:begin -->\nold\n<!-- results:end -->\nrest\n";
  const std::string once = replace_result_block(text, "new\n", "README.md");
  EXPECT_EQ(once, "# Title\n<!-- results:begin -->\nnew\n<!-- results:end -->\nrest\n");
  EXPECT_EQ(replace_result_block(once, "new\n", "README.md"), once);
}

TEST(ReplaceResultBlock, WantsEachMarkerOnceAndInOrder) {
  const auto replace = [](const char* text) {
    return [text] { replace_result_block(text, "new", "README.md"); };
  };
  expect_input_error(replace("no markers"),
                     HasSubstr("README.md: the marker '<!-- results:begin -->' is missing"));
  expect_input_error(replace("<!-- results:begin -->"), HasSubstr("'<!-- results:end -->' is missing"));
  expect_input_error(replace("<!-- results:begin --><!-- results:begin --><!-- results:end -->"),
                     HasSubstr("appears twice"));
  expect_input_error(replace("<!-- results:end --><!-- results:begin -->"),
                     HasSubstr("before the begin marker"));
}

// Rows of URP's filters and of ours that are the same filter have the same figures, at the same bias: what
// stands once in a table stands for both, and a package that was changed by hand is found.
TEST(PublishedPeers, UrpsFiltersAndOursAreTheSame) {
  const Results results = read_results(std::filesystem::path(PENUMBRA_SOURCE_DIR) /
                                       "Documentation~/results/equal-bias/results.tsv");
  for (const auto& [urp, ours] :
       {std::pair{"urp-low", "four-tap"}, {"urp-medium", "tent-5"}, {"urp-high", "tent-7"}}) {
    for (const Record& record : results.records) {
      if (record.technique != urp) continue;
      const Record* same = find_record(results, ours, record.scene, record.light_degrees);
      ASSERT_NE(same, nullptr) << ours;
      EXPECT_NEAR(*record.metrics.rmse_penumbra, *same->metrics.rmse_penumbra, 0.002)
          << urp << ", " << record.scene;
      EXPECT_EQ(record.metrics.fetches_mean, same->metrics.fetches_mean) << urp;
    }
  }
}

// Results may be a stranger's, and the titles stand in comments of C#.
TEST(PublishedPresets, ATitleDoesNotEndItsComment) {
  Results results =
      read_results(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "Documentation~/results/presets/results.tsv");
  const std::string before = preset_figures_csharp(results, "preset-");
  for (const char* end : {"\n", "\r", "\u0085", "\u2028", "\u2029", "\u202E"}) {
    Results evil = results;
    for (Record& record : evil.records) record.title = std::string("a") + end + "class Evil {} //";
    const std::string text = preset_figures_csharp(evil, "preset-");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::count(before.begin(), before.end(), '\n'));
    EXPECT_THAT(text, HasSubstr("// a class Evil {} //\n"));
  }
}

TEST(PublishedPresets, AFigureThatIsMissingIsNoRow) {
  Results results =
      read_results(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "Documentation~/results/presets/results.tsv");
  const std::string last = results.records.back().technique;
  results.records.pop_back();  // it is the last technique's last scene
  expect_input_error([&] { (void)preset_figures_csharp(results, last); },
                     HasSubstr("was not measured on every scene"));
  expect_input_error([&] { (void)preset_figures_csharp(results, "nothing-"); },
                     HasSubstr("no quality preset was measured"));
}

}  // namespace
}  // namespace penumbra::study
