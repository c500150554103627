// Compares with ray tracing: a filter with the opacity mask has far less error under wires and smoke than
// without.
#include <gtest/gtest.h>

#include "study/small_study.h"

namespace penumbra::study {
namespace {

TEST(BlendedCasters, TheOpacityMaskTakesMostOfTheErrorUnderThem) {
  SmallStudy study(scene::built_in("wires-and-smoke"), 0.53, 320, 180);
  study.settings.frame.shadows.resolution = 2048;
  const StudyOutcome outcome = study.run(library_subjects(
      {"pcss-angular-24-16", "pcss-angular-24-16-opacity", "single-loop-32", "single-loop-32-opacity"}));
  ASSERT_EQ(outcome.records.size(), 4U);
  const auto error = [&](std::size_t i) { return outcome.records[i].metrics.rmse_penumbra.value(); };
  for (const Record& record : outcome.records) EXPECT_EQ(record.metrics.invalid, 0U);
  EXPECT_LT(error(1), 0.3 * error(0));  // 0.11 was measured
  EXPECT_LT(error(3), 0.6 * error(2));  // 0.41 was measured
}

}  // namespace
}  // namespace penumbra::study
