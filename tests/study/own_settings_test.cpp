// Every subject runs at the casters' bias and with the diameter that it asks for, against the same ray
// tracing.
#include <gmock/gmock.h>

#include "input/input_error.h"
#include "study/small_study.h"

namespace penumbra::study {
namespace {

Subject subject(const std::string& technique, const std::string& name) {
  Subject made = library_subject(technique);
  made.name = name;
  return made;
}

StudyOutcome outcome(const std::vector<Subject>& subjects, double degrees, bool split = false) {
  SmallStudy study(scene::built_in("contact-boxes"), degrees, 96, 54);
  study.settings.frame.shadows.resolution = 1024;
  study.settings.split_error = split;
  return study.run(subjects);
}

TEST(OwnSettings, TheListSaysTheBiasOfEachTechnique) {
  EXPECT_EQ(subject("tent-7", "a").bias, (parameters::CasterBias{1.0, 1.0, parameters::SoftQuality::high}));
  EXPECT_EQ(subject("preset-high", "a").bias,
            (parameters::CasterBias{1.0, 0.0, parameters::SoftQuality::medium}));
  EXPECT_EQ(subject("preset-high", "a").raster_bias, scene::kUnityRasterBias);
  techniques::Technique own = library_techniques().find("tent-7");
  own.bias.slope = 0.5;
  EXPECT_EQ(technique_subject(library_techniques(), own, true).raster_bias, (scene::RasterBias{1.0, 0.5}));
}

TEST(OwnSettings, ATechniqueForSpotLightsIsRefused) {
  EXPECT_THAT([] { library_subject("pcss-spot-24-16"); },
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("the technique 'pcss-spot-24-16' is for spot lights")));
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
  const StudyOutcome of = outcome({half, subject("pcss-angular-24-16", "whole")}, 5.0, true);
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
  Subject biased = bare;
  biased.name = "biased";
  bare.raster_bias = {};
  const StudyOutcome both = outcome({bare, biased}, 2.0);
  const Record& without = both.records[0];
  const Record& with = both.records[1];
  EXPECT_EQ(without.settings.slope_bias, 0.0);
  EXPECT_EQ(with.settings.slope_bias, 2.5);
  EXPECT_GT(*without.metrics.false_shadow_rate, 0.1);
  EXPECT_LT(*with.metrics.false_shadow_rate, 0.1 * *without.metrics.false_shadow_rate);
}

}  // namespace
}  // namespace penumbra::study
