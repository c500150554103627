// Tests the presets as they are published: a higher one has a smaller error under every light, and costs more
// arithmetic.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "study/summary.h"

namespace penumbra::study {
namespace {

TEST(PublishedPresets, EachIsBetterThanTheOneBelowUnderEveryLightAndComputesMore) {
  const std::filesystem::path root = PENUMBRA_SOURCE_DIR;
  const Results results = read_results(root / "Documentation~/results/presets/results.tsv");
  const std::vector<double> lights = light_sizes(results);
  EXPECT_EQ(lights, (std::vector<double>{0.53, 2.0, 5.0}));
  std::map<std::pair<std::string, double>, SummaryLine> lines;
  for (const SummaryLine& line : summarise(results)) lines[{line.choice.label, line.light_degrees}] = line;

  const std::vector<std::string> presets{"preset-low", "preset-medium", "preset-high", "preset-ultra"};
  for (const double light : lights) {
    for (std::size_t i = 0; i < presets.size(); ++i) {
      ASSERT_EQ(lines.count({presets[i], light}), 1) << presets[i] << " at " << light << " degrees";
      const SummaryLine& line = lines.at({presets[i], light});
      EXPECT_TRUE(line.complete) << presets[i];
      if (i == 0) continue;
      const SummaryLine& below = lines.at({presets[i - 1], light});
      EXPECT_LT(line.rmse_penumbra.value().value, below.rmse_penumbra.value().value)
          << presets[i] << " at " << light << " degrees";
      EXPECT_GT(line.operations.value().value, below.operations.value().value)
          << presets[i] << " at " << light << " degrees";
    }
  }
}

}  // namespace
}  // namespace penumbra::study
