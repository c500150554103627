#include "study/summary.h"

#include <gmock/gmock.h>

#include "study/synthetic_study.h"

namespace penumbra::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const SummaryLine& line(const std::vector<SummaryLine>& lines, const std::string& label, double light) {
  for (const SummaryLine& candidate : lines) {
    if (candidate.choice.label == label && candidate.light_degrees == light) return candidate;
  }
  throw std::runtime_error("no line for " + label);
}

void set_rmse(Results& results, const std::string& technique, const std::string& scene,
              std::optional<double> rmse) {
  for (Record& record : results.records) {
    if (record.technique != technique || record.scene != scene) continue;
    record.metrics.rmse_penumbra = rmse;
    if (!rmse) record.metrics.penumbra_pixels = 0;
  }
}

TEST(Summary, ScenesWeighTheSameWhateverTheirSize) {
  Results results = synthetic::results();
  set_rmse(results, "tent-5x5", "boxes", 0.1);
  set_rmse(results, "tent-5x5", "fence", 0.3);
  for (Record& record : results.records) {
    if (record.scene == "fence") record.metrics.penumbra_pixels = 1;
    record.metrics.preprocess_fetches_per_pixel = 0.25;
  }
  const std::vector<SummaryLine> lines = summarise(results);
  const SummaryLine& tent = line(lines, "tent-5x5", 2.0);
  EXPECT_DOUBLE_EQ(tent.rmse_penumbra.value().value, 0.2);
  EXPECT_DOUBLE_EQ(tent.fetches.value().value, 10.25) << "preparation is part of the cost";
  EXPECT_DOUBLE_EQ(tent.time_ms.value(), 1.0 / 3.0 + 1.0);
  EXPECT_EQ(tent.scenes, 2U);
  EXPECT_TRUE(tent.complete);
}

TEST(Summary, AMeanOverFewerScenesIsNotComplete) {
  Results results = synthetic::results();
  results.records.erase(results.records.begin());  // the record of boxes, bilinear, 0.53 degrees
  const std::vector<SummaryLine> lines = summarise(results);
  EXPECT_FALSE(line(lines, "bilinear", 0.53).complete);
  EXPECT_TRUE(line(lines, "bilinear", 2.0).complete);
  EXPECT_TRUE(line(lines, "tent-5x5", 0.53).complete);
}

TEST(Summary, ASceneWithoutPenumbraMakesNobodyIncomplete) {
  Results results = synthetic::results();
  for (const char* technique : {"bilinear", "tent-5x5", "pcss-24-16", "pcss-64-64"}) {
    set_rmse(results, technique, "fence", std::nullopt);
  }
  const std::vector<SummaryLine> lines = summarise(results);
  EXPECT_TRUE(line(lines, "bilinear", 2.0).complete);
  EXPECT_EQ(line(lines, "bilinear", 2.0).scenes, 1U);
}

TEST(Summary, SeveralMapsAreSeveralChoices) {
  Results results = synthetic::results({"bilinear"});
  EXPECT_THAT(choices(results),
              ElementsAre(Choice{"bilinear", "bilinear", "Title of bilinear", "Title of bilinear"}));
  const std::vector<Record> first = results.records;
  for (Record record : first) {
    record.map_size = 4096;
    record.map_format = "D16";
    results.records.push_back(record);
  }
  ASSERT_EQ(choices(results).size(), 2U);
  EXPECT_EQ(choices(results)[1].label, "bilinear (4096 D16, 4 cascades)");
  EXPECT_EQ(choices(results)[1].shown, "Title of bilinear (4096 D16, 4 cascades)");
  EXPECT_EQ(find_record(results, choices(results)[1].label, "boxes", 2.0)->map_size, 4096);
  EXPECT_EQ(find_record(results, "bilinear", "boxes", 2.0), nullptr);
}

TEST(Headlines, AreTheBestTheBargainAndTheCheapest) {
  Results results = synthetic::results();
  for (const char* scene : {"boxes", "fence"}) {
    set_rmse(results, "bilinear", scene, 0.300);
    set_rmse(results, "tent-5x5", scene, 0.200);
    set_rmse(results, "pcss-24-16", scene, 0.109);
    set_rmse(results, "pcss-64-64", scene, 0.100);
  }
  const std::vector<Headline> found = headlines(results);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].value, "0.100");
  EXPECT_EQ(found[0].detail, "Title of pcss-64-64, 28 fetches per pixel");
  EXPECT_EQ(found[1].value, "19");
  EXPECT_EQ(found[1].detail, "Title of pcss-24-16, error 0.109");
  EXPECT_EQ(found[2].value, "0.300");
  EXPECT_EQ(found[2].detail, "Title of bilinear, 1 fetch per pixel");

  // Beyond 10 % of the best, the bargain would be the best itself, and is not told again.
  for (const char* scene : {"boxes", "fence"}) set_rmse(results, "pcss-24-16", scene, 0.111);
  const std::vector<Headline> fewer = headlines(results);
  ASSERT_EQ(fewer.size(), 2U);
  EXPECT_EQ(fewer[1].detail, "Title of bilinear, 1 fetch per pixel");
  EXPECT_EQ(headlines(synthetic::results({"bilinear"})).size(), 1U);
}

TEST(Headlines, LeaveOutWhoWasNotMeasuredEverywhere) {
  Results results = synthetic::results();
  set_rmse(results, "pcss-64-64", "boxes", 0.001);
  std::erase_if(results.records, [](const Record& record) {
    return record.technique == "pcss-64-64" && record.scene == "fence";
  });
  EXPECT_THAT(headlines(results)[0].detail, HasSubstr("pcss-24-16"));
  EXPECT_TRUE(headlines(Results{}).empty());
}

}  // namespace
}  // namespace penumbra::study
