// A study of techniques that run over the screen, from the list to the record.
#include <gmock/gmock.h>

#include "reference/scratch_folder.h"
#include "resolve/test_device.h"
#include "study/study.h"

namespace penumbra::study {
namespace {

std::map<std::string, Record> recorded(const std::vector<std::string>& techniques, bool reversed_z,
                                       int pan_frames = 0) {
  const reference::ScratchFolder cache;
  StudySettings settings;
  settings.scenes = {scene::built_in("contact-boxes")};
  settings.light_degrees = {2.0};
  settings.frame.width = 120;
  settings.frame.height = 68;
  settings.frame.shadows.cascades = 4;
  settings.frame.shadows.normal_bias = 0.0;
  settings.frame.shadows.reversed_z = reversed_z;
  settings.reference_samples = 64;
  settings.noise_seeds = 2;
  settings.timing_repeats = 1;
  settings.split_error = false;
  settings.cache = cache.path();
  settings.pan_frames = pan_frames;
  std::vector<Subject> subjects;
  for (const std::string& name : techniques) {
    const techniques::TechniqueList& list = library_techniques();
    subjects.push_back(technique_subject(list, list.find(name), reversed_z));
  }
  const StudyOutcome outcome = run_study(test_device(), subjects, settings, [](auto&&...) {});
  EXPECT_THAT(outcome.notes, testing::IsEmpty());
  std::map<std::string, Record> records;
  for (const Record& record : outcome.records) {
    records[record.technique] = record;
    EXPECT_TRUE(record.time) << record.technique;
  }
  return records;
}

TEST(ScreenStudy, ARecordHoldsAllPassesTogether) {
  for (const bool reversed_z : {true, false}) {
    const auto of = recorded({"pcss-angular-24-16", "screen-pcss-angular-24-16",
                              "screen-pcss-angular-24-16-masked", "screen-pcss-angular-24-16-half"},
                             reversed_z);
    const Metrics& alone = of.at("pcss-angular-24-16").metrics;
    const Metrics& screen = of.at("screen-pcss-angular-24-16").metrics;
    const Metrics& masked = of.at("screen-pcss-angular-24-16-masked").metrics;
    const Metrics& half = of.at("screen-pcss-angular-24-16-half").metrics;
    for (const auto& [name, record] : of) {
      EXPECT_EQ(record.metrics.invalid, 0u) << name;
      EXPECT_FALSE(record.shimmer) << name;
    }

    EXPECT_NEAR(*screen.rmse_penumbra, *alone.rmse_penumbra, 0.002);
    EXPECT_EQ(screen.seeds, 2u);
    EXPECT_FALSE(screen.mask);
    EXPECT_EQ(screen.preprocess_fetches_per_pixel, 0.0);
    EXPECT_GE(*screen.fetches_mean, *alone.fetches_mean + 5.0) << "camera depths count, too";
    EXPECT_LE(*screen.fetches_mean, *alone.fetches_mean + 9.0);

    ASSERT_TRUE(masked.mask);
    EXPECT_GT(masked.mask->pixels_saved, 0.0);
    EXPECT_EQ(masked.mask->penumbra_pixels_missed, 0.0);
    EXPECT_EQ(masked.rmse_penumbra, screen.rmse_penumbra) << "nothing was missed";
    EXPECT_GT(masked.preprocess_fetches_per_pixel, 0.5);

    EXPECT_LT(*half.fetches_mean + half.preprocess_fetches_per_pixel, 0.5 * *screen.fetches_mean);
    EXPECT_GT(*half.rmse_penumbra, *screen.rmse_penumbra);
  }
}

// A fixed filter sees the same points at the same places of the map: what is left is the rounding of
// positions. Noise that stands on the screen passes over the points, noise that moves differs by itself.
TEST(ScreenStudy, OnlyNoiseShimmersUnderAPan) {
  const auto of = recorded({"tent-5", "pcss-angular-24-16", "screen-pcss-angular-24-16"}, true, 3);
  const Shimmer fixed = of.at("tent-5").shimmer.value();
  EXPECT_EQ(fixed.frames, 3);
  EXPECT_LT(fixed.static_noise.value(), 0.002);
  EXPECT_EQ(fixed.static_noise, fixed.per_frame_noise);
  const Shimmer noisy = of.at("pcss-angular-24-16").shimmer.value();
  EXPECT_GT(noisy.static_noise.value(), 0.01);
  EXPECT_GT(noisy.per_frame_noise.value(), 0.01);
  EXPECT_NE(noisy.static_noise, noisy.per_frame_noise);
  EXPECT_GT(of.at("screen-pcss-angular-24-16").shimmer.value().per_frame_noise.value(), 0.01);
}

}  // namespace
}  // namespace penumbra::study
