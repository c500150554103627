// Compares with ray tracing: a filter with the opacity mask has far less error under wires and smoke than
// without.
#include <gtest/gtest.h>

#include "reference/scratch_folder.h"
#include "resolve/test_device.h"
#include "study/study.h"

namespace penumbra::study {
namespace {

TEST(BlendedCasters, TheOpacityMaskTakesMostOfTheErrorUnderThem) {
  const reference::ScratchFolder cache;
  const techniques::TechniqueList& list = library_techniques();
  StudySettings settings;
  settings.scenes = {scene::built_in("wires-and-smoke")};
  settings.light_degrees = {0.53};
  settings.frame.width = 320;
  settings.frame.height = 180;
  settings.frame.shadows.resolution = 2048;
  settings.frame.shadows.cascades = 4;
  settings.reference_samples = 64;
  settings.noise_seeds = 1;
  settings.timing_repeats = 0;
  settings.split_error = false;
  settings.cache = cache.path();
  std::vector<Subject> subjects;
  for (const char* name :
       {"pcss-angular-24-16", "pcss-angular-24-16-opacity", "single-loop-32", "single-loop-32-opacity"})
    subjects.push_back(technique_subject(list, list.find(name), true));
  const StudyOutcome outcome = run_study(test_device(), subjects, settings, [](auto&&...) {});
  ASSERT_EQ(outcome.records.size(), 4U);
  const auto error = [&](std::size_t i) { return outcome.records[i].metrics.rmse_penumbra.value(); };
  for (const Record& record : outcome.records) EXPECT_EQ(record.metrics.invalid, 0U);
  EXPECT_LT(error(1), 0.3 * error(0));  // 0.11 was measured
  EXPECT_LT(error(3), 0.6 * error(2));  // 0.41 was measured
}

}  // namespace
}  // namespace penumbra::study
