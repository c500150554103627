// Exits must leave a technique's error as it is; where a device draws something else, its results say so.
#include "study/exits_difference.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "study/synthetic_study.h"

namespace penumbra::study {
namespace {

// Each record twice, without exits and with them.
Results results_with_exits() {
  Results results = synthetic::results({"tent-5"});
  for (Record exits : std::vector<Record>(results.records)) {
    exits.technique += "-exits";
    results.records.push_back(exits);
  }
  return results;
}

Record& first_exits(Results& results) {
  return *std::find_if(results.records.begin(), results.records.end(),
                       [](const Record& record) { return record.technique == "tent-5-exits"; });
}

TEST(DifferingExits, NoneWhereErrorsAreTheSame) {
  Results results = results_with_exits();
  EXPECT_TRUE(differing_exits(results).empty());
  *first_exits(results).metrics.rmse_all += 0.9 * kExitsTolerance;
  EXPECT_TRUE(differing_exits(results).empty()) << "rounding";
}

TEST(DifferingExits, AreThoseWithAnotherErrorOfAnyKind) {
  const std::vector<std::pair<std::optional<double> Metrics::*, std::string>> figures = {
      {&Metrics::rmse_all, "RMSE of all pixels"},
      {&Metrics::rmse_penumbra, "RMSE in penumbra"},
      {&Metrics::bias, "bias in penumbra"},
      {&Metrics::leak_rate, "share of light leaks"},
      {&Metrics::false_shadow_rate, "share of false shadow"}};
  for (const auto& [figure, name] : figures) {
    Results results = results_with_exits();
    Record& exits = first_exits(results);
    const double without = *(exits.metrics.*figure);
    *(exits.metrics.*figure) += 1.1 * kExitsTolerance;
    const std::vector<ExitsDifference> found = differing_exits(results);
    ASSERT_EQ(found.size(), 1U) << name;
    EXPECT_EQ(found[0].exits, &exits);
    EXPECT_EQ(found[0].plain->technique, "tent-5");
    EXPECT_EQ(found[0].plain->scene, exits.scene);
    EXPECT_EQ(found[0].plain->light_degrees, exits.light_degrees);
    EXPECT_EQ(found[0].figure, name);
    EXPECT_EQ(found[0].without, without);
    EXPECT_EQ(found[0].with, without + 1.1 * kExitsTolerance);
    exits.metrics.*figure = std::nullopt;
    EXPECT_EQ(differing_exits(results).size(), 1U) << "only one of both has it";
  }
}

TEST(DifferingExits, AreFoundInRowsThatAreCalledByTheirSettings) {
  Results results = results_with_exits();
  for (Record& record : results.records) record.technique += " minFilterTexels=2";
  const auto exits = std::find_if(results.records.begin(), results.records.end(), [](const Record& record) {
    return record.technique == "tent-5-exits minFilterTexels=2";
  });
  ASSERT_NE(exits, results.records.end());
  *exits->metrics.rmse_all += 0.1;
  ASSERT_EQ(differing_exits(results).size(), 1U);
  EXPECT_EQ(differing_exits(results)[0].plain->technique, "tent-5 minFilterTexels=2");
}

TEST(DifferingExits, OtherSettingsAreOtherCases) {
  Results results = results_with_exits();
  *first_exits(results).metrics.rmse_all += 0.5;
  first_exits(results).settings.normal_bias += 1.0;
  EXPECT_TRUE(differing_exits(results).empty());
}

}  // namespace
}  // namespace penumbra::study
