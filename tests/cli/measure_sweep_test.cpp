// penumbra measure --set measures values of a technique's parameters side by side.
#include <nlohmann/json.hpp>
#include <set>

#include "cli/program.h"

namespace penumbra {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class MeasureSweep : public ProgramTest {
 protected:
  Words small(const Words& options) const {
    return joined(words("measure --size 48x27 --map-size 512 --scene slabs --light 2 --reference-samples 32 "
                        "--seeds 1 --timing-repeats 0 --no-split",
                        {"--cache", path("cache").string()}),
                  options);
  }
};

TEST_F(MeasureSweep, EveryValueIsARecordWithItsOwnNameAndParameters) {
  const auto result = expect_success(small(
      {"--technique", "pcss-angular-24-16", "--set", "blockerSamples=2,4", "--set", "filterSamples=1,16"}));
  const nlohmann::json records = nlohmann::json::parse(result.output).at("records");
  std::set<std::string> names;
  for (const nlohmann::json& record : records) {
    const auto value = [&](const char* name) { return record.at("parameters").at(name).at(0).get<int>(); };
    names.insert(record.at("technique"));
    const std::string set = "blockerSamples=" + std::to_string(value("blockerSamples")) +
                            " filterSamples=" + std::to_string(value("filterSamples"));
    EXPECT_EQ(record.at("technique"), "pcss-angular-24-16 " + set);
    EXPECT_EQ(record.at("title"), "PCSS 24+16 " + set);
    EXPECT_GE(record.at("fetches_mean"), value("blockerSamples"));
    EXPECT_LE(record.at("fetches_mean"), value("blockerSamples") + value("filterSamples"));
  }
  EXPECT_EQ(records.size(), 4);
  EXPECT_EQ(names.size(), 4);
}

// A value that is set for one technique takes the place of what is set for all.
TEST_F(MeasureSweep, AParameterOfOneTechniqueLeavesTheOthersAsTheyAre) {
  const auto result = expect_success(small(
      {"--technique", "pcss-angular-24-16,godot-pcss-8,pcss-angular-64-64", "--set", "godot-pcss-8:samples=3",
       "--set", "pcss-angular-24-16:blockerSamples=5", "--set", "pcss-angular-64-64:blockerSamples=6,7"}));
  const nlohmann::json results = nlohmann::json::parse(result.output);
  std::vector<std::string> names;
  for (const nlohmann::json& record : results.at("records")) names.push_back(record.at("technique"));
  EXPECT_THAT(names,
              ElementsAre("pcss-angular-24-16 blockerSamples=5", "godot-pcss-8 samples=3",
                          "pcss-angular-64-64 blockerSamples=6", "pcss-angular-64-64 blockerSamples=7"));
  EXPECT_EQ(results.at("records")[0].at("parameters").at("filterSamples").at(0), 16);

  const auto own =
      expect_success(small({"--technique", "pcss-angular-24-16,pcss-angular-64-64", "--set",
                            "blockerSamples=4", "--set", "pcss-angular-24-16:blockerSamples=5"}));
  const nlohmann::json records = nlohmann::json::parse(own.output).at("records");
  EXPECT_EQ(records[0].at("parameters").at("blockerSamples").at(0), 5);
  EXPECT_EQ(records[1].at("parameters").at("blockerSamples").at(0), 4);

  expect_bad_input(small({"--technique", "hard", "--set", "godot-pcss-8:samples=3"}),
                   HasSubstrs("--set godot-pcss-8:samples: 'godot-pcss-8' is not among the",
                              "add --technique godot-pcss-8"));
}

TEST_F(MeasureSweep, AgesOfTheMapAreMeasuredSideBySide) {
  const auto result = expect_success(small({"--technique", "tent-5", "--map-age", "0,2"}));
  const nlohmann::json results = nlohmann::json::parse(result.output);
  const nlohmann::json& records = results.at("records");
  ASSERT_EQ(records.size(), 2);
  EXPECT_EQ(records[0].at("technique"), "tent-5 map-age=0");
  EXPECT_FALSE(records[0].at("settings").contains("map_age_degrees"));
  EXPECT_EQ(records[1].at("technique"), "tent-5 map-age=2");
  EXPECT_EQ(records[1].at("settings").at("map_age_degrees"), 2.0);
  EXPECT_GT(records[1].at("rmse_all"), records[0].at("rmse_all"));
  EXPECT_EQ(run(small({"--map-age", "11"})).exit_code, 2);
}

TEST_F(MeasureSweep, WhatCannotBeSetIsRefusedBeforeAnythingIsMeasured) {
  expect_bad_input(small({"--technique", "pcss-angular-24-16", "--set", "blockerSample=2"}),
                   HasSubstr("did you mean 'blockerSamples'?"));
  EXPECT_THAT(listing(), IsEmpty());
}

}  // namespace
}  // namespace penumbra
