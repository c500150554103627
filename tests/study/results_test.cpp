#include "study/results.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "input/input_error_matcher.h"
#include "study/synthetic_study.h"

namespace penumbra::study {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string message_of(const std::string& text) {
  return input_error_of([&] { parse_results(text, "results.json"); });
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

int line_of(const std::string& text, const std::string& what) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find(what));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

// Results as `measure` may find them, with any figure absent, any setting and any name.
class RandomResults {
 public:
  explicit RandomResults(unsigned seed) : random_(seed) {}

  Results operator()() {
    Results results = synthetic::results(names());
    results.is_software = coin();
    if (coin()) results.front_end = "FXC 10.0";
    if (coin()) results.commit = std::nullopt;
    if (coin()) results.packages.clear();
    for (Record& record : results.records) vary(record);
    for (MeasuredFrame& frame : results.frames) {
      frame.sun_direction = {share(), -share(), share()};
      frame.camera.position = {1e5 * share(), share() / 3.0, -share()};
    }
    return results;
  }

 private:
  bool coin() { return random_() % 2 == 0; }
  double share() { return static_cast<double>(random_()) / 4294967295.0; }
  std::optional<double> figure() { return coin() ? std::optional(share()) : std::nullopt; }
  std::optional<Interval> interval() {
    const double low = share();
    return coin() ? std::optional(Interval{low, low + (1.0 - low) * share(), share()}) : std::nullopt;
  }
  std::vector<std::string> names() {
    std::vector<std::string> names{"hard", "my \"own\" filter", "Schattenfilter für weiche Ränder", "a|b"};
    names.resize(1 + random_() % names.size());
    return names;
  }
  CascadeRecord cascade() {
    CascadeRecord record{
        random_() % 9, random_() % 9, figure(), figure(),
        figure(),      figure(),      figure(), {interval(), interval(), interval(), interval(), interval()}};
    if (coin()) record.technique = "tent-5";
    if (!record.technique.empty() && coin())
      record.parameters = {{"taps", {share()}}, {"offset", {1.0, share()}}};
    record.texel_size_metres = figure();
    return record;
  }
  void vary(Record& record) {
    Metrics& metrics = record.metrics;
    for (std::optional<double> Metrics::*member :
         {&Metrics::rmse_penumbra, &Metrics::rmse_all, &Metrics::bias, &Metrics::variance, &Metrics::p99,
          &Metrics::max_error, &Metrics::leak_rate, &Metrics::false_shadow_rate, &Metrics::fetches_mean,
          &Metrics::fetches_p95, &Metrics::fetches_penumbra_mean}) {
      metrics.*member = figure();
    }
    metrics.intervals = {interval(), interval(), interval(), interval(), interval()};
    metrics.invalid = random_() % 9;
    if (coin()) metrics.mask = MaskShares{share(), figure()};
    if (coin()) metrics.split.map = ErrorShare{-share(), share()};
    if (coin()) record.shimmer = Shimmer{static_cast<int>(random_() % 9), figure(), figure()};
    if (coin())
      record.passes = {{"Rows", "cascade", share(), share(), 64.0 * share()},
                       {"Resolve",
                        "frame",
                        share(),
                        share(),
                        {},
                        100.0 * share(),
                        share(),
                        share(),
                        share(),
                        share(),
                        3.0},
                       {"Tiles",
                        "frame",
                        share(),
                        share(),
                        {},
                        share(),
                        share(),
                        {},
                        share(),
                        share(),
                        {},
                        1.0,
                        240.0 * share(),
                        share()}};
    if (coin()) record.operations_per_pixel = 1000.0 * share();
    if (coin()) record.time = std::nullopt;
    if (coin()) record.parameters.clear();
    record.cascades = 1 + static_cast<int>(random_() % 4);
    if (coin() && record.cascades > 1)
      for (int i = 0; i < record.cascades; ++i) record.per_cascade.push_back(cascade());
    record.settings.splits.assign(static_cast<std::size_t>(record.cascades - 1), share());
    record.settings.normal_bias = 10.0 * share();
    record.settings.slope_bias = share();
    record.settings.light_scale = share();
    record.settings.soft_quality = static_cast<parameters::SoftQuality>(random_() % 4);
    record.settings.reversed_z = coin();
    if (coin()) record.settings.cascade_choices.blend = {0.5 + 0.5 * share(), coin()};
    if (coin()) record.seam = Seam{random_() % 9, figure(), figure()};
    if (coin()) record.overlap = OverlapRecord{random_() % 9, figure(), figure()};
    if (coin()) record.flip = share();
    if (coin()) record.group_step = GroupStep{random_() % 9, figure(), figure()};
    record.settings.cascade_choices.light_fit =
        parameters::kLightFits[random_() % parameters::kLightFits.size()];
    if (coin()) record.settings.cascade_choices.map_age_degrees = 10.0 * share();
  }

  std::mt19937 random_;
};

TEST(Results, WhateverIsWrittenReadsBackEqual) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Results results = RandomResults(seed)();
    ASSERT_EQ(parse_results(to_json(results), "results.json"), results) << "seed " << seed;
  }
}

// Settings are exact; figures have seven digits, ends of intervals five. What is not a number comes back as
// it was.
TEST(Results, ATableHoldsTheSame) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Results results = RandomResults(seed)();
    const std::string table = to_table(results);
    const Results read = parse_results(table, "results.tsv");
    EXPECT_EQ(to_table(read), table) << "seed " << seed;
    ASSERT_EQ(read.frames, results.frames);
    ASSERT_EQ(read.records.size(), results.records.size());
    for (std::size_t i = 0; i < results.records.size(); ++i) {
      EXPECT_EQ(read.records[i].settings, results.records[i].settings);
      EXPECT_EQ(read.records[i].parameters, results.records[i].parameters);
    }
    const nlohmann::json written = nlohmann::json::parse(to_json(results)).flatten();
    const nlohmann::json found = nlohmann::json::parse(to_json(read)).flatten();
    ASSERT_EQ(found.size(), written.size()) << "seed " << seed;
    for (const auto& [path, value] : written.items()) {
      // Seven digits, five of intervals, and two fewer of single cascades.
      const double rounding = (path.find("intervals/") == std::string::npos ? 5.1e-7 : 5.1e-5) *
                              (path.find("per_cascade/") == std::string::npos ? 1.0 : 100.0);
      if (value.is_number())
        EXPECT_NEAR(found.at(path).get<double>(), value.get<double>(),
                    rounding * std::abs(value.get<double>()))
            << path;
      else
        EXPECT_EQ(found.at(path), value) << path;
    }
  }
}

TEST(Results, ATableNamesTheCellThatIsWrong) {
  Results results = synthetic::results();
  results.records[0].metrics.rmse_all = 0.71828;
  const std::string table = to_table(results);
  const std::size_t cell = table.find("\t0.71828") + 1;
  const std::size_t line_start = table.rfind('\n', cell) + 1;
  const std::string place = "results.json:" + std::to_string(line_of(table, "\t0.71828")) + ":" +
                            std::to_string(cell - line_start + 1) + ": ";
  EXPECT_THAT(message_of(replaced(table, "0.71828", "7.1828")),
              StartsWith(place + "'rmse_all' must be between 0 and 1"));
}

TEST(Results, TheSameResultsAreTheSameBytes) {
  EXPECT_EQ(to_json(synthetic::results()), to_json(synthetic::results()));
}

TEST(Results, ARecordHasEveryFieldOfTheDesign) {
  const nlohmann::json json = nlohmann::json::parse(to_json(synthetic::results()));
  const auto expect_keys = [](const nlohmann::json& object, const std::string& keys) {
    std::istringstream words(keys);
    for (std::string key; words >> key;) EXPECT_TRUE(object.contains(key)) << key;
  };
  expect_keys(json["records"][0],
              "scene technique parameters light_degrees map_size device rmse_penumbra rmse_all bias variance "
              "p99 max_error leak_rate false_shadow_rate fetches_mean fetches_p95 fetches_penumbra_mean "
              "preprocess_fetches_per_pixel time_ms_median time_ms_spread settings intervals");
  expect_keys(json["records"][0]["reference"], "kind samples noise_floor");
  expect_keys(json, "hardware driver device is_software command library_version commit packages frames");
  EXPECT_EQ(json["schema_version"], 2);
}

TEST(Results, AnAbsentFigureIsNullAndNotZero) {
  Results results = synthetic::results();
  results.records[0].metrics.rmse_penumbra = std::nullopt;
  results.commit = std::nullopt;
  const nlohmann::json json = nlohmann::json::parse(to_json(results));
  EXPECT_TRUE(json["records"][0]["rmse_penumbra"].is_null());
  EXPECT_TRUE(json["commit"].is_null());
  for (const char* absent : {"mask", "shimmer"}) EXPECT_FALSE(json["records"][0].contains(absent)) << absent;
}

TEST(Results, TimesOfASoftwareDeviceAreCalledCpuTime) {
  Results results = synthetic::results();
  EXPECT_EQ(nlohmann::json::parse(to_json(results))["records"][0]["time_kind"], "CPU time");
  results.is_software = false;
  EXPECT_EQ(nlohmann::json::parse(to_json(results))["records"][0]["time_kind"], "GPU time");
}

TEST(Results, AnInvalidValueAnywhereIsAFinding) {
  Results results = synthetic::results();
  EXPECT_FALSE(has_invalid_values(results));
  results.records.back().metrics.invalid = 1;
  EXPECT_TRUE(has_invalid_values(results));
}

TEST(Results, NamesOfStrayBytesDoNotStopTheWriter) {
  Results results = synthetic::results();
  results.driver = "bad \xFF byte";
  EXPECT_EQ(parse_results(to_json(results), "results.json").driver, "bad \xEF\xBF\xBD byte");
}

TEST(ResultsReader, PointsAtTheLineThatIsWrong) {
  const std::string good = to_json(synthetic::results());
  const std::string place = "results.json:" + std::to_string(line_of(good, "\"rmse_penumbra\"")) + ":";
  EXPECT_THAT(message_of(replaced(good, "\"rmse_penumbra\": 0", "\"rmse_penumbra\": 7")), StartsWith(place));
  EXPECT_THAT(message_of(replaced(good, "\"rmse_penumbra\": ", "\"rmse_penumbra\": \"x\", \"y\": ")),
              testing::AllOf(StartsWith(place), HasSubstr("must be a number, found a string")));
}

TEST(ResultsReader, RefusesWhatTheWriterWouldNotWrite) {
  Results results = synthetic::results();
  results.records[0].metrics.mask = MaskShares{0.5, 0.125};
  const std::string good = to_json(results);
  EXPECT_EQ(message_of(good), "no error");
  const char* const refused[][3] = {
      {"\"schema_version\": 2", "\"schema_version\": 1", "schema version 1 is not the 2 this program reads"},
      {"\"bias\"", "\"biass\"", "'bias' is missing"},
      {"\"title\"", "\"extra\": 1, \"title\"", "unknown key 'extra'"},
      {"\"leak_rate\": ", "\"leak_rate\": 2", "'leak_rate' must be between 0 and 1"},
      {"\"pixels_saved\": 0.5", "\"pixels_saved\": 1.5", "'pixels_saved' must be between 0 and 1"},
      {"\"seeds\": 16", "\"seeds\": -16", "must not be negative"},
      {"\"time_ms_spread\": 0.1", "\"time_ms_spread\": null", "must be null exactly when"},
      {"\"CPU time\"", "\"GPU time\"", "must be \"CPU time\""},
      {"\"records\": [", "\"records\": 3, \"x\": [", "'records' must be an array"}};
  for (const auto& [from, to, says] : refused)
    EXPECT_THAT(message_of(replaced(good, from, to)), HasSubstr(says)) << to;
  EXPECT_THAT(message_of("{}"), HasSubstr("'schema_version' is missing"));
  EXPECT_THAT(message_of(""), HasSubstr("is empty"));
}

TEST(ResultsReader, EveryRecordHasOneFrame) {
  Results results = synthetic::results();
  const MeasuredFrame last = results.frames.back();
  results.frames.pop_back();
  EXPECT_THAT(message_of(to_json(results)), HasSubstr("'frames' has no entry of the record's fence × 2°"));
  results.frames.push_back(last);
  results.frames.push_back(last);
  EXPECT_THAT(message_of(to_json(results)), HasSubstr("a second frame of fence × 2°"));
}

TEST(ResultsReader, AnIntervalRunsUpwards) {
  Results results = synthetic::results();
  results.records[0].metrics.intervals.leak_rate = Interval{0.5, 0.25, 0.1};
  EXPECT_THAT(message_of(to_json(results)), HasSubstr("must not lie below 'low'"));
}

TEST(ResultsReader, EachCascadeHasItsEntry) {
  Results results = synthetic::results();
  results.records[0].per_cascade.resize(3);
  EXPECT_THAT(message_of(to_json(results)),
              HasSubstr("'per_cascade' must have one entry for each of the 4 cascades, not 3"));
}

TEST(ResultsReader, RefusesTheSameMeasurementTwice) {
  Results results = synthetic::results();
  results.records.push_back(results.records.front());
  EXPECT_THAT(message_of(to_json(results)), HasSubstr("a second record of boxes × bilinear × 0.53°"));
}

}  // namespace
}  // namespace penumbra::study
