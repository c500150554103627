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

TEST(OwnSettings, ALightOfTheOtherKindIsRefusedBeforeAnyWork) {
  StudySettings settings = SmallStudy(scene::built_in("contact-boxes"), 2.0, 96, 54).settings;
  settings.scenes[0].spot_light.emplace();
  const auto run = [&] {
    run_study(test_device(), {subject("tent-7", "a")}, settings, [](auto&&...) { FAIL() << "it began"; });
  };
  EXPECT_THAT(run, testing::ThrowsMessage<InputError>(testing::HasSubstr(
                       "scene 'contact-boxes' is lit by a spot light, and 'a' runs for the sun")));
  const auto make = [](const char* technique, techniques::LightKind light) {
    return [technique, light] { library_subject(technique, light); };
  };
  EXPECT_THAT(make("pcss-angular-24-16", techniques::LightKind::spot),
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("the technique 'pcss-angular-24-16' is not for spot lights")));
  EXPECT_THAT(make("pcss-spot-24-16", techniques::LightKind::directional),
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("the technique 'pcss-spot-24-16' is not for the sun")));
  settings.scenes.push_back(scene::built_in("trees"));
  EXPECT_THAT(
      [&] { light_kind(settings.scenes); },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("measure the two kinds of light in two runs")));
  settings.scenes.pop_back();
  settings.split_error = true;
  const Subject spot = library_subject("tent-5", techniques::LightKind::spot);
  EXPECT_THAT([&] { run_study(test_device(), {spot}, settings, [](auto&&...) {}); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("--no-split")));
}

TEST(OwnSettings, ASpotLightsSourceIsAsWideAsTheStudySays) {
  SmallStudy study(scene::built_in("spot-table"), 1.0, 160, 90);
  study.settings.light_degrees.push_back(8.0);
  study.settings.frame.shadows.resolution = 512;
  ASSERT_EQ(study.settings.frame.shadows.cascades, 4) << "the sun's maps; a spot light has one";
  std::vector<Subject> subjects;
  for (const char* name : {"hard", "tent-5-plane", "pcss-spot-24-16"})
    subjects.push_back(library_subject(name, techniques::LightKind::spot));
  const StudyOutcome outcome = study.run(subjects);
  ASSERT_EQ(outcome.frames.size(), 2U);
  ASSERT_EQ(outcome.records.size(), 6U);
  EXPECT_NEAR(outcome.frames[0].source_radius_metres.value(), 0.008727, 1e-6);
  EXPECT_NEAR(outcome.frames[1].source_radius_metres.value(), 0.069927, 1e-6);
  for (const Record& record : outcome.records) {
    EXPECT_THAT(record.reference.kind, testing::StartsWith("ray-traced spot light, source radius 0.0"));
    EXPECT_EQ(record.cascades, 1);
    EXPECT_TRUE(record.settings.splits.empty());
    EXPECT_EQ(record.metrics.invalid, 0U);
    EXPECT_GT(record.metrics.penumbra_pixels, 50U);
  }
  EXPECT_GT(outcome.records[3].metrics.penumbra_pixels, 2 * outcome.records[0].metrics.penumbra_pixels);
  // PCSS knows of the wide source, and the others do not.
  EXPECT_LT(outcome.records[5].metrics.rmse_penumbra.value(),
            0.6 * outcome.records[3].metrics.rmse_penumbra.value());
  EXPECT_LT(outcome.records[5].metrics.rmse_penumbra.value(),
            0.6 * outcome.records[4].metrics.rmse_penumbra.value());

  Results results;
  results.frames = outcome.frames;
  results.records = outcome.records;
  results.records.resize(3);
  results.frames.resize(1);
  const Results read = parse_results(to_json(results), "results.json");
  EXPECT_EQ(read.frames[0].source_radius_metres, results.frames[0].source_radius_metres);
  EXPECT_EQ(read.records[2].reference.kind, results.records[2].reference.kind);
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
