// Every subject runs at the casters' bias and with the diameter that it asks for, against the same ray
// tracing.
#include <gmock/gmock.h>

#include "input/input_error.h"
#include "reference/scratch_folder.h"
#include "resolve/test_device.h"
#include "study/study.h"

namespace penumbra::study {
namespace {

Subject subject(const std::string& technique, const std::string& name) {
  const techniques::TechniqueList& list = library_techniques();
  Subject made = technique_subject(list, list.find(technique), true);
  made.name = name;
  return made;
}

StudyOutcome outcome(const std::vector<Subject>& subjects, double degrees, scene::RasterBias raster = {},
                     bool split = false) {
  const reference::ScratchFolder cache;
  StudySettings settings;
  settings.scenes = {scene::built_in("contact-boxes")};
  settings.light_degrees = {degrees};
  settings.frame.width = 96;
  settings.frame.height = 54;
  settings.frame.raster_bias = raster;
  settings.frame.shadows.cascades = 4;
  settings.frame.shadows.resolution = 1024;
  settings.reference_samples = 64;
  settings.noise_seeds = 1;
  settings.timing_repeats = 0;
  settings.split_error = split;
  settings.cache = cache.path();
  return run_study(test_device(), subjects, settings, [](auto&&...) {});
}

TEST(OwnSettings, TheListSaysTheBiasOfEachTechnique) {
  EXPECT_EQ(subject("tent-7", "a").bias, (parameters::CasterBias{1.0, 1.0, parameters::SoftQuality::high}));
  EXPECT_EQ(subject("preset-high", "a").bias,
            (parameters::CasterBias{1.0, 0.0, parameters::SoftQuality::medium}));
}

TEST(OwnSettings, ASpotLightIsRefusedBeforeAnyWork) {
  StudySettings settings;
  settings.scenes = {scene::built_in("contact-boxes")};
  settings.scenes[0].spot_light.emplace();
  const auto run = [&] {
    run_study(test_device(), {subject("tent-7", "a")}, settings, [](auto&&...) { FAIL() << "it began"; });
  };
  EXPECT_THAT(run, testing::ThrowsMessage<InputError>(
                       testing::HasSubstr("scene 'contact-boxes' is lit by a spot light")));
}

TEST(OwnSettings, SubjectsOfOneRunHaveTheirOwnCasters) {
  Subject moved = subject("tent-7", "moved");
  Subject still = subject("tent-7", "still");
  still.bias.normal = 0.0;
  const StudyOutcome together = outcome({moved, still}, 2.0);
  ASSERT_EQ(together.records.size(), 2U);
  EXPECT_EQ(together.frames.size(), 1U);
  EXPECT_EQ(together.records[0].settings.normal_bias, 1.0);
  EXPECT_EQ(together.records[0].settings.soft_quality, parameters::SoftQuality::high);
  EXPECT_EQ(together.records[1].settings.normal_bias, 0.0);
  EXPECT_EQ(together.pictures[0].reference, together.pictures[1].reference) << "one ray tracing";
  EXPECT_NE(together.pictures[0].result, together.pictures[1].result);
  EXPECT_EQ(together.records[1].metrics, outcome({still}, 2.0).records[0].metrics)
      << "as if it had been alone";
}

TEST(OwnSettings, ASubjectThatIsToldHalfTheDiameterMakesHalfThePenumbra) {
  Subject half = subject("pcss-angular-24-16", "half");
  half.light_scale = 0.5;
  const StudyOutcome of = outcome({half, subject("pcss-angular-24-16", "whole")}, 5.0, {}, true);
  EXPECT_EQ(of.records[0].settings.light_scale, 0.5);
  EXPECT_EQ(of.records[0].light_degrees, 5.0) << "the light stays what it is";
  EXPECT_EQ(of.pictures[0].reference, of.pictures[1].reference);
  EXPECT_EQ(of.records[0].metrics.split.map, of.records[1].metrics.split.map)
      << "T2 is of the light as it is";
  EXPECT_GT(*of.records[0].metrics.rmse_penumbra, 1.3 * *of.records[1].metrics.rmse_penumbra);
}

// Without any bias the ground shadows itself; the rasteriser's bias by slope alone clears it.
TEST(OwnSettings, TheRasterisersBiasLiftsTheGroundsShadowOffItself) {
  Subject bare = subject("hard", "bare");
  bare.bias = {0.0, 0.0, parameters::SoftQuality::off};
  const Record without = outcome({bare}, 2.0).records[0];
  const Record with = outcome({bare}, 2.0, scene::kUnityRasterBias).records[0];
  EXPECT_EQ(without.settings.slope_bias, 0.0);
  EXPECT_EQ(with.settings.slope_bias, 2.5);
  EXPECT_GT(*without.metrics.false_shadow_rate, 0.1);
  EXPECT_LT(*with.metrics.false_shadow_rate, 0.1 * *without.metrics.false_shadow_rate);
}

}  // namespace
}  // namespace penumbra::study
