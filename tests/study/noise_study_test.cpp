// The techniques of noise/NoiseStudy.technique.json are the library's own but for what they are named after.
#include <gmock/gmock.h>

#include "study/small_study.h"

namespace penumbra::study {
namespace {

const techniques::TechniqueList& noise_techniques() {
  static const techniques::TechniqueList list = techniques::read_technique_list(
      std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests/study/noise/NoiseStudy.technique.json");
  return list;
}

Subject noise_subject(const std::string& technique) {
  return technique_subject(noise_techniques(), noise_techniques().find(technique), true);
}

Subject remembering(Subject subject, double history) {
  subject.history = history;
  subject.name += " remembering";
  return subject;
}

StudyOutcome noise_outcome(const std::vector<Subject>& subjects, int seeds = 1) {
  SmallStudy study(scene::built_in("trees"), 5.0, 160, 90);
  study.settings.frame.shadows.resolution = 256;
  study.settings.noise_seeds = seeds;
  return study.run(subjects);
}

double all_fetches(const Record& record) {
  return *record.metrics.fetches_mean + record.metrics.preprocess_fetches_per_pixel;
}

TEST(NoiseStudy, GradientNoiseIsTheLibrarys) {
  const StudyOutcome of = noise_outcome(
      {library_subject("screen-pcss-angular-24-16"), noise_subject("pcss-24-16-gradient"),
       library_subject("screen-pcss-angular-24-16-denoised"), noise_subject("pcss-24-16-gradient-denoised")});
  for (const std::size_t library : {0U, 2U}) {
    EXPECT_EQ(of.pictures[library].result, of.pictures[library + 1].result) << of.records[library].technique;
    EXPECT_EQ(of.records[library].metrics, of.records[library + 1].metrics) << of.records[library].technique;
  }
}

TEST(NoiseStudy, TheMaskTurnsDisksForOneFetch) {
  const StudyOutcome of =
      noise_outcome({noise_subject("pcss-24-16-gradient"), noise_subject("pcss-24-16-mask")});
  EXPECT_NE(of.pictures[0].result, of.pictures[1].result);
  const double fetches = all_fetches(of.records[1]) - all_fetches(of.records[0]);
  EXPECT_GT(fetches, 0.5);
  EXPECT_LE(fetches, 1.1);  // the number of a filter's fetches depends on what its search finds
  EXPECT_NEAR(*of.records[1].metrics.rmse_penumbra, *of.records[0].metrics.rmse_penumbra, 0.01);
}

TEST(NoiseStudy, AHistoryHasLessErrorThanEachFrame) {
  const Subject each = noise_subject("pcss-24-16-mask");
  const StudyOutcome of =
      noise_outcome({each, remembering(each, 0.2), remembering(library_subject("variance-32"), 0.2)}, 3);
  const Metrics& frame = of.records[0].metrics;
  const Metrics& history = of.records[1].metrics;
  EXPECT_EQ(history.seeds, 3U);
  EXPECT_LT(*history.rmse_penumbra, *frame.rmse_penumbra);
  EXPECT_LT(*history.variance, 0.2 * *frame.variance);
  EXPECT_EQ(history.fetches_mean, frame.fetches_mean) << "of one frame";
  EXPECT_EQ(of.records[2].metrics.seeds, 1U) << "every frame of it is the same";
}

}  // namespace
}  // namespace penumbra::study
