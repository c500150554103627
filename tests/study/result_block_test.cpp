#include "study/result_block.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "input/input_error_matcher.h"
#include "study/preset_figures.h"
#include "study/summary.h"
#include "study/synthetic_study.h"

namespace penumbra::study {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kChart = "Documentation~/results/pareto-fetches.svg";

std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream) << file << " is missing";
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ResultBlock, NamesHardwareDriverAndCommandThenTableThenChart) {
  const std::string block = result_block(synthetic::results(), kChart);
  const std::vector<std::string> order{
      "made-up processor",
      "made-up driver 1.2",
      "com.example.shadows 17.0.3, com.example.core.",
      "`penumbra measure --seed 1`",
      "0.53° light, 2 scenes, 18000 penumbra pixels, 9000 in the scene with fewest:",
      "| Technique | RMSE in penumbra | RMSE of all pixels | light leaks, % | "
      "false shadow, % | fetches per pixel |",
      "2° light, 2 scenes",
      "](Documentation~/results/pareto-fetches.svg)"};
  std::size_t last = 0;
  for (const std::string& part : order) {
    const std::size_t at = block.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    EXPECT_GT(at, last) << part;
    last = at;
  }
}

TEST(ResultBlock, TablesHoldMeansAndEveryScene) {
  Results results = synthetic::results();
  results.records[0].metrics.rmse_penumbra = 0.2;    // boxes, bilinear, 0.53°
  results.records[8].metrics.rmse_penumbra = 0.125;  // fence, bilinear, 0.53°
  ASSERT_EQ(results.records[8].scene, "fence");
  results.records[0].metrics.intervals.rmse_penumbra = Interval{0.19, 0.22, 0.008};
  results.records[8].metrics.intervals.rmse_penumbra = Interval{0.12, 0.13, 0.0025};
  const std::string block = result_block(results, kChart);
  EXPECT_THAT(block, HasSubstr("| bilinear | 0.2 ± 0.5 | 0.0"));
  EXPECT_THAT(block, HasSubstr("| bilinear | 0.200 ± 0.020 | 0.125 ± 0.005 |"));
  EXPECT_THAT(block, Not(HasSubstr(" ms"))) << "CPU time has no place in the README";
}

TEST(ResultBlock, AMeanOverFewerScenesSaysSo) {
  Results results = synthetic::results();
  results.records.erase(results.records.begin());
  EXPECT_THAT(result_block(results, kChart), HasSubstr("(1 scenes)"));
}

TEST(ResultBlock, NamesCannotBreakTheTable) {
  Results results = synthetic::results({"a|b<c>\nd"});
  EXPECT_THAT(result_block(results, kChart), HasSubstr("| a\\|b&lt;c> d |"));
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
                     HasSubstr("stands twice"));
  expect_input_error(replace("<!-- results:end --><!-- results:begin -->"),
                     HasSubstr("before their beginning"));
}

struct PublishedPage {
  std::string name;
  std::string file;
  std::string results;
  std::string chart;            // from the repository's root
  std::string chart_from_page;  // as the page names it
};

void PrintTo(const PublishedPage& page, std::ostream* stream) {
  *stream << page.file;
}

class Published : public testing::TestWithParam<PublishedPage> {};

// The figures a visitor reads are those of the committed file; scripts/publish measures and writes both.
TEST_P(Published, ShowsTheCommittedResults) {
  const PublishedPage& page = GetParam();
  const std::filesystem::path root = PENUMBRA_SOURCE_DIR;
  const Results results = read_results(root / page.results);
  const std::string text = file_text(root / page.file);
  EXPECT_EQ(text, replace_result_block(text, result_block(results, page.chart_from_page), page.file));
  const std::string chart = file_text(root / page.chart);
  for (const Choice& choice : choices(results)) {
    EXPECT_THAT(chart, HasSubstr(">" + choice.label + "<")) << "the chart is of other results";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Page, Published,
    testing::Values(PublishedPage{"Readme", "README.md", "Documentation~/results/results.json",
                                  "Documentation~/results/pareto-fetches.svg",
                                  "Documentation~/results/pareto-fetches.svg"},
                    PublishedPage{"Bias", "Documentation~/bias.md",
                                  "Documentation~/results/urp-default-bias/results.json",
                                  "Documentation~/results/urp-default-bias/pareto-fetches.svg",
                                  "results/urp-default-bias/pareto-fetches.svg"},
                    PublishedPage{"FarOrigin", "Documentation~/far-origin.md",
                                  "Documentation~/results/far-origin/results.json",
                                  "Documentation~/results/far-origin/pareto-fetches.svg",
                                  "results/far-origin/pareto-fetches.svg"},
                    PublishedPage{"Presets", "Documentation~/presets.md",
                                  "Documentation~/results/presets/results.json",
                                  "Documentation~/results/presets/pareto-fetches.svg",
                                  "results/presets/pareto-fetches.svg"}),
    [](const auto& instance) { return instance.param.name; });

// What the inspector shows.
TEST(PublishedPresets, AreTheCommittedResults) {
  const std::filesystem::path root = PENUMBRA_SOURCE_DIR;
  const Results results = read_results(root / "Documentation~/results/presets/results.json");
  EXPECT_EQ(file_text(root / "Editor/Inspectors/PresetFigures.cs"),
            preset_figures_csharp(results, "preset-"));
}

TEST(PublishedPresets, AFigureThatIsMissingIsNoRow) {
  Results results = read_results(std::filesystem::path(PENUMBRA_SOURCE_DIR) /
                                 "Documentation~/results/presets/results.json");
  const std::string last = results.records.back().technique;
  results.records.pop_back();  // the last technique's last scene
  EXPECT_THROW((void)preset_figures_csharp(results, last), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::study
