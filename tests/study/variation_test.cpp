// Runs a technique with other values, over a part of the picture, or averaged: each really reaches the
// answer.
#include <gmock/gmock.h>

#include <cmath>

#include "study/colour_map.h"
#include "study/small_study.h"
#include "techniques/technique_list.h"

namespace penumbra::study {
namespace {

constexpr int kFrames = 8;

Subject with(const std::string& technique, const std::map<std::string, double>& values) {
  const techniques::TechniqueList& list = library_techniques();
  techniques::Technique varied = list.find(technique);
  for (const auto& [name, value] : values) varied = with_value(list, std::move(varied), name, value);
  return technique_subject(list, varied, true);
}

StudyOutcome outcome(const std::vector<Subject>& subjects,
                     const std::optional<PictureWindow>& window = std::nullopt,
                     std::function<void(const SubjectAnswer&)> answered = {}) {
  SmallStudy study(scene::built_in("trees"), 2.0, 96, 54);
  study.settings.noise_seeds = kFrames;
  study.settings.window = window;
  study.settings.answered = std::move(answered);
  return study.run(subjects);
}

class Variation : public testing::TestWithParam<const char*> {};

TEST_P(Variation, MoreSamplesFetchMoreAndErrLess) {
  const StudyOutcome of =
      outcome({with(GetParam(), {{"blockerSamples", 1.0}}), with(GetParam(), {{"blockerSamples", 64.0}})});
  EXPECT_NE(of.pictures[0].result, of.pictures[1].result);
  EXPECT_GT(*of.records[0].metrics.rmse_penumbra, 1.5 * *of.records[1].metrics.rmse_penumbra);
  EXPECT_GT(*of.records[1].metrics.fetches_mean, *of.records[0].metrics.fetches_mean + 30.0);
  EXPECT_EQ(of.records[0].parameters.at("blockerSamples"), std::vector<double>{1.0});
}

TEST_P(Variation, TheValueItHasAlreadyChangesNothing) {
  const StudyOutcome of = outcome(
      {with(GetParam(), {}), with(GetParam(), {{"blockerSamples", 24.0}, {"minFilterTexels", 1.25}})});
  EXPECT_EQ(of.pictures[0].result, of.pictures[1].result);
  EXPECT_EQ(of.records[0].metrics, of.records[1].metrics);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Variation,
                         testing::Values("pcss-angular-24-16", "screen-pcss-angular-24-16-masked"));

TEST(ScreenVariation, TheDenoisersValueReachesItsPass) {
  const char* technique = "screen-pcss-angular-24-16-denoised";
  const StudyOutcome of = outcome({with(technique, {{"denoiseRadius", 0.0}}), with(technique, {}),
                                   with("screen-pcss-angular-24-16", {})});
  EXPECT_EQ(of.pictures[0].result, of.pictures[2].result) << "of radius 0";
  EXPECT_NE(of.pictures[1].result, of.pictures[2].result);
}

// The mean square of the frames' errors is that of their mean, and the frames' variance.
TEST(AveragedFrames, AreTheMeanOfTheFrames) {
  Subject averaged = with("pcss-angular-24-16", {});
  averaged.averaged_frames = kFrames;
  const StudyOutcome of = outcome({with("pcss-angular-24-16", {}), averaged});
  const Metrics& each = of.records[0].metrics;
  const Metrics& mean = of.records[1].metrics;
  EXPECT_EQ(mean.seeds, 1u);
  ASSERT_GT(*each.variance, 1e-4);
  const double variance = *each.variance * (kFrames - 1) / kFrames;
  EXPECT_NEAR(std::pow(*each.rmse_penumbra, 2), std::pow(*mean.rmse_penumbra, 2) + variance, 1e-6);
  EXPECT_EQ(mean.fetches_mean, each.fetches_mean) << "of one frame";
}

TEST(Answers, AreHandedOverAsNumbersInTheRecordsOrder) {
  std::vector<std::string> names;
  std::vector<Picture> drawn;
  const StudyOutcome of = outcome(
      {with("tent-5", {}), with("pcss-angular-24-16", {})}, std::nullopt, [&](const SubjectAnswer& answer) {
        names.push_back(answer.record.technique);
        const PixelGrid grid{answer.frame.settings.width, answer.frame.settings.height,
                             answer.reference.valid};
        drawn.push_back(visibility_picture(grid, answer.visibility));
      });
  ASSERT_EQ(names, (std::vector<std::string>{"tent-5", "pcss-angular-24-16"}));
  for (std::size_t i = 0; i < drawn.size(); ++i) EXPECT_EQ(drawn[i], of.pictures[i].result.unpacked());
}

// Errors and fetches of the cascades' pixels make up those of the picture.
TEST(PerCascade, FiguresAreOfThePixelsThatReadIt) {
  std::size_t in_first = 0;
  const StudyOutcome of =
      outcome({with("pcss-angular-24-16", {})}, std::nullopt, [&](const SubjectAnswer& answer) {
        const glm::dvec4 sphere = answer.frame.cascades.cascades.front().split_sphere;
        for (std::size_t i = 0; i < answer.reference.valid.size(); ++i) {
          const glm::dvec3 surface{answer.frame.receivers.position_ws[i]};
          const bool inside = glm::distance(surface, glm::dvec3(sphere)) < sphere.w;
          in_first += inside && answer.reference.valid[i] != 0 ? 1U : 0U;
        }
      });
  const Metrics& all = of.records.front().metrics;
  const std::vector<CascadeRecord>& cascades = of.records.front().per_cascade;
  ASSERT_EQ(cascades.size(), 4u);
  EXPECT_EQ(cascades.front().pixels, in_first);
  EXPECT_GT(cascades.front().penumbra_pixels, 0u);
  EXPECT_NE(cascades.front().pixels, all.pixels);
  std::size_t pixels = 0;
  std::size_t penumbra_pixels = 0;
  double fetches = 0.0;
  double squares = 0.0;
  for (const CascadeRecord& cascade : cascades) {
    pixels += cascade.pixels;
    penumbra_pixels += cascade.penumbra_pixels;
    fetches += cascade.fetches_mean.value_or(0.0) * static_cast<double>(cascade.pixels);
    squares +=
        std::pow(cascade.rmse_penumbra.value_or(0.0), 2) * static_cast<double>(cascade.penumbra_pixels);
  }
  EXPECT_EQ(pixels, all.pixels);
  EXPECT_EQ(penumbra_pixels, all.penumbra_pixels);
  EXPECT_NEAR(fetches / static_cast<double>(pixels), *all.fetches_mean, 1e-9 * *all.fetches_mean);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(penumbra_pixels)), *all.rmse_penumbra, 1e-9);
}

// Both halves of the picture make up the whole, passes at lower resolution included.
TEST(Window, FiguresAreOfItAlone) {
  const std::vector<Subject> subjects{with("screen-pcss-angular-24-16-half-masked-denoised", {})};
  const StudyOutcome all = outcome(subjects);
  const StudyOutcome left = outcome(subjects, PictureWindow{0, 0, 48, 54});
  const StudyOutcome right = outcome(subjects, PictureWindow{48, 0, 48, 54});
  const Metrics& of_all = all.records[0].metrics;
  const Metrics& of_left = left.records[0].metrics;
  const Metrics& of_right = right.records[0].metrics;
  EXPECT_EQ(of_left.pixels + of_right.pixels, of_all.pixels);
  const auto sum = [](const Metrics& metrics, double figure) {
    return figure * static_cast<double>(metrics.pixels);
  };
  EXPECT_NEAR(sum(of_left, *of_left.fetches_mean) + sum(of_right, *of_right.fetches_mean),
              sum(of_all, *of_all.fetches_mean), 1e-6 * sum(of_all, *of_all.fetches_mean));
  EXPECT_NE(of_left.preprocess_fetches_per_pixel, of_right.preprocess_fetches_per_pixel);
  // Fifty-four rows are no whole blocks of four, so the last row of blocks counts for its share here.
  EXPECT_NEAR((of_left.preprocess_fetches_per_pixel + of_right.preprocess_fetches_per_pixel) / 2.0,
              of_all.preprocess_fetches_per_pixel, 0.02 * of_all.preprocess_fetches_per_pixel);
  EXPECT_EQ(left.pictures[0].result, all.pictures[0].result) << "pictures are of everything";
}

}  // namespace
}  // namespace penumbra::study
