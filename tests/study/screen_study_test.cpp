// Tests a study of techniques that run over the screen, from the list to the record.
#include <gmock/gmock.h>

#include "study/small_study.h"

namespace penumbra::study {
namespace {

std::map<std::string, Record> recorded(const std::vector<techniques::Technique>& techniques, bool reversed_z,
                                       int pan_frames = 0) {
  SmallStudy study(scene::built_in("contact-boxes"), 2.0, 120, 68);
  study.settings.frame.shadows.reversed_z = reversed_z;
  study.settings.noise_seeds = 2;
  study.settings.timing_repeats = 1;
  study.settings.pan_frames = pan_frames;
  std::vector<Subject> subjects;
  for (const techniques::Technique& technique : techniques)
    subjects.push_back(technique_subject(library_techniques(), technique, reversed_z));
  std::map<std::string, Record> records = study.records(subjects);
  for (const auto& [name, record] : records) EXPECT_TRUE(record.time) << name;
  return records;
}

std::map<std::string, Record> recorded(const std::vector<std::string>& names, bool reversed_z,
                                       int pan_frames = 0) {
  std::vector<techniques::Technique> listed;
  for (const std::string& name : names) listed.push_back(library_techniques().find(name));
  return recorded(listed, reversed_z, pan_frames);
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

// A fixed filter sees the same points at the same places of the map, so only the rounding of positions is
// left. Noise that stands on the screen passes over the points; noise that moves differs by itself.
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

// The casters have the same bias, so that all draw the same map.
TEST(ScreenStudy, ACascadeHasTheAnswerOfTheRuleForIt) {
  const techniques::TechniqueList& list = library_techniques();
  const techniques::Technique& pcss = list.find("pcss-angular-24-16");
  const techniques::Technique& tent = list.find("tent-5-plane");
  techniques::Technique fewer = pcss, mixed = pcss;
  fewer.name = "fewer";
  fewer.values["filterSamples"] = {5.0};
  mixed.name = "mixed";
  const techniques::FilterCall& own = *pcss.graph.filter();
  mixed.cascades = {{1, "", own, {{"filterSamples", {5.0}}}, pcss.unlimited},
                    {2, tent.name, *tent.graph.filter(), {}, {}}};
  const auto of = recorded(std::vector<techniques::Technique>{pcss, fewer, tent, mixed}, true);
  const std::vector<CascadeRecord>& cascades = of.at("mixed").per_cascade;
  ASSERT_EQ(cascades.size(), 4U);
  const char* const expected[] = {"pcss-angular-24-16", "fewer", "tent-5-plane", "tent-5-plane"};
  for (std::size_t i = 0; i < cascades.size(); ++i) {
    const CascadeRecord& alone = of.at(expected[i]).per_cascade.at(i);
    EXPECT_GT(cascades[i].pixels, 0U) << i;
    EXPECT_EQ(cascades[i].rmse_penumbra, alone.rmse_penumbra) << i;
    EXPECT_EQ(cascades[i].fetches_mean, alone.fetches_mean) << i;
    EXPECT_EQ(cascades[i].false_shadow_rate, alone.false_shadow_rate) << i;
  }
  EXPECT_EQ(cascades[0].technique, "");
  EXPECT_EQ(cascades[1].technique, "mixed");
  EXPECT_EQ(cascades[1].parameters.at("filterSamples"), std::vector<double>{5.0});
  EXPECT_EQ(cascades[3].technique, "tent-5-plane");
}

}  // namespace
}  // namespace penumbra::study
