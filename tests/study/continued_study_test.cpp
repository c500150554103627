// A study that was interrupted between two techniques, and one that was not, give the same results.
#include <gtest/gtest.h>

#include <set>

#include "platform/interrupt.h"
#include "reference/scratch_folder.h"
#include "resolve/test_device.h"
#include "study/kept_records.h"
#include "study/study.h"

namespace penumbra::study {
namespace {

namespace fs = std::filesystem;

std::vector<Subject> subjects(const std::vector<std::string>& names) {
  const techniques::TechniqueList& list = library_techniques();
  std::vector<Subject> all;
  for (const std::string& name : names) all.push_back(technique_subject(list, list.find(name), true));
  return all;
}

StudySettings settings(const fs::path& cache) {
  StudySettings settings;
  settings.scenes = {scene::built_in("trees")};
  settings.light_degrees = {2.0};
  settings.frame.width = 64;
  settings.frame.height = 36;
  settings.frame.shadows.cascades = 4;
  settings.reference_samples = 32;
  settings.noise_seeds = 2;
  settings.timing_repeats = 0;
  settings.split_error = false;
  settings.cache = cache;
  return settings;
}

std::size_t kept_in(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    count += entry.path().extension() == std::string(".") + kept_record_kind;
  return count;
}

// Interrupts when the technique's turn comes.
StudyProgress until(const std::string& technique) {
  return [technique](std::string_view stage, double, double, std::string_view) {
    if (stage.ends_with(", " + technique)) throw platform::Interrupted();
  };
}

TEST(ContinuedStudy, HasTheResultsOfOneThatWasNotInterrupted) {
  const reference::ScratchFolder whole_cache, cache;
  const std::vector<Subject> chosen =
      subjects({"tent-5-plane", "pcss-angular-24-16", "screen-pcss-angular-24-16-masked"});
  const StudyOutcome whole = run_study(test_device(), chosen, settings(whole_cache.path()), [](auto&&...) {});
  EXPECT_EQ(kept_in(whole_cache.path()), 0U) << "nothing is kept of a study that is finished";

  EXPECT_THROW(run_study(test_device(), chosen, settings(cache.path()), until(chosen[2].name)),
               platform::Interrupted);
  EXPECT_EQ(kept_in(cache.path()), 2U);
  const StudyOutcome continued = run_study(test_device(), chosen, settings(cache.path()), [](auto&&...) {});
  EXPECT_EQ(kept_in(cache.path()), 0U);
  EXPECT_EQ(continued.records, whole.records);
  ASSERT_EQ(continued.pictures.size(), whole.pictures.size());
  for (std::size_t i = 0; i < whole.pictures.size(); ++i) {
    EXPECT_EQ(continued.pictures[i].result, whole.pictures[i].result) << chosen[i].name;
    EXPECT_EQ(continued.pictures[i].fetch_counts, whole.pictures[i].fetch_counts) << chosen[i].name;
    EXPECT_EQ(continued.pictures[i].mask, whole.pictures[i].mask) << chosen[i].name;
  }
}

// What differs is measured again: settings, and a technique's values.
TEST(ContinuedStudy, TakesNothingFromAnotherStudy) {
  const reference::ScratchFolder cache;
  std::vector<Subject> chosen = subjects({"pcss-angular-24-16", "hard"});
  EXPECT_THROW(run_study(test_device(), chosen, settings(cache.path()), until("hard")),
               platform::Interrupted);
  ASSERT_EQ(kept_in(cache.path()), 1U);

  StudySettings other = settings(cache.path());
  other.noise_seeds = 3;
  EXPECT_EQ(run_study(test_device(), chosen, other, [](auto&&...) {}).records.at(0).metrics.seeds, 3);
  EXPECT_EQ(kept_in(cache.path()), 1U) << "of the first study";

  chosen[0].title = "another title";
  EXPECT_EQ(run_study(test_device(), chosen, settings(cache.path()), [](auto&&...) {}).records.at(0).title,
            "another title");
}

TEST(ContinuedStudy, HasPicturesOnlyWhereTheyAreWanted) {
  const reference::ScratchFolder cache;
  const std::vector<Subject> chosen = subjects({"tent-5", "hard"});
  StudySettings figures = settings(cache.path());
  figures.pictures = false;
  const StudyOutcome without = run_study(test_device(), chosen, figures, [](auto&&...) {});
  for (const PictureRow& row : without.pictures) EXPECT_TRUE(row.result.empty() && row.technique.empty());
  EXPECT_THROW(run_study(test_device(), chosen, figures, until("hard")), platform::Interrupted);
  const StudyOutcome with = run_study(test_device(), chosen, settings(cache.path()), [](auto&&...) {});
  EXPECT_EQ(with.records, without.records);
  for (const PictureRow& row : with.pictures) EXPECT_FALSE(row.result.empty()) << row.technique;
}

// A picture of a lit scene needs each technique's own answer.
TEST(ContinuedStudy, KeepsNothingWhereAnswersArePassedOn) {
  const reference::ScratchFolder cache;
  StudySettings passing = settings(cache.path());
  int answers = 0;
  passing.answered = [&](const SubjectAnswer&) { ++answers; };
  const std::vector<Subject> chosen = subjects({"tent-5", "hard"});
  EXPECT_THROW(run_study(test_device(), chosen, passing, until("hard")), platform::Interrupted);
  EXPECT_EQ(kept_in(cache.path()), 0U);
  run_study(test_device(), chosen, passing, [](auto&&...) {});
  EXPECT_EQ(answers, 3);
}

}  // namespace
}  // namespace penumbra::study
