// JSON is written and read back, and shards are joined.
#include "validation/report_merge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "input/input_error.h"
#include "shaders/shader_files.h"
#include "validation/report_fixture.h"

namespace penumbra::validation {
namespace {

using testing::AllOf;
using testing::HasSubstr;

ValidationReport read_back(const std::string& json) {
  const shaders::ShaderFiles files;
  return read_report_json(files.write("report.json", json));
}

std::string refusal(const std::string& json) {
  try {
    read_back(json);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

// Every member is away from its default, so that none can be left out unseen.
ValidationReport full_report() {
  VariantRecord record = failed(water({"A", "B"}), error_at("a.hlsl", 2, 3, "no"));
  record.technique = "tent-5";
  record.diagnostics[0].source_line = "x\ty";
  record.diagnostics[0].rule = "rule";
  record.reason = "because";
  record.cached = true;
  record.reproduction = "crash.hlsl";
  record.module = "0123";
  record.place = 7;
  ValidationReport report;
  report.records = {record};
  report.unique = 1;
  report.seconds = 0.125;
  report.checks = {{"spirv", "glslang"}};
  report.rules = {{"rule", "finds"}};
  report.shard = 2;
  report.shards = 3;
  report.fingerprint = "f00d";
  report.packages = {"Packages/com.y"};
  return report;
}

TEST(ReportJson, ReadsBackWhatItWrote) {
  const ValidationReport report = full_report();
  const ValidationReport again = read_back(report_json(report));
  EXPECT_EQ(report_json(again), report_json(report));
  EXPECT_EQ(report_text(again), report_text(report));
  const VariantRecord& a = again.records.at(0);
  const VariantRecord& b = report.records.at(0);
  EXPECT_EQ(std::tie(a.technique, a.file, a.shader, a.pass, a.entry, a.stage, a.keywords, a.target, a.status,
                     a.reason, a.cached, a.reproduction, a.module, a.place),
            std::tie(b.technique, b.file, b.shader, b.pass, b.entry, b.stage, b.keywords, b.target, b.status,
                     b.reason, b.cached, b.reproduction, b.module, b.place));
  EXPECT_EQ(a.diagnostics.at(0).source_line, "x\ty");
  EXPECT_EQ(a.diagnostics.at(0).rule, "rule");
  EXPECT_EQ(std::tie(again.unique, again.seconds, again.checks, again.rules, again.shard, again.shards,
                     again.fingerprint, again.packages),
            std::tie(report.unique, report.seconds, report.checks, report.rules, report.shard, report.shards,
                     report.fingerprint, report.packages));
}

TEST(ReportJson, OtherFilesAreRefusedAtTheirPlace) {
  EXPECT_THAT(refusal("{}"), AllOf(HasSubstr("report.json"), HasSubstr("not a report of penumbra validate")));
  EXPECT_THAT(refusal("[1]"), HasSubstr("expected an object"));
  const std::string good = report_json(full_report());
  const auto with = [&](const std::string& part, const std::string& instead) {
    std::string text = good;
    return refusal(text.replace(text.find(part), part.size(), instead));
  };
  EXPECT_THAT(with("\"fragment\"", "\"fragmint\""), AllOf(HasSubstr("report.json:"), HasSubstr("fragmint")));
  EXPECT_THAT(with("\"status\":\"failed\"", "\"status\":\"broken\""), HasSubstr("unknown status 'broken'"));
  EXPECT_THAT(with("\"failed\": 1", "\"failed\": 0"), HasSubstr("is not what the results count: 1"));
  for (const char* index : {"\"index\": 4", "\"index\": 0", "\"index\": -5"})
    EXPECT_THAT(with("\"index\": 2", index), HasSubstr("from 1 to their count")) << index;
  EXPECT_THAT(with("\"line\":2", "\"line\":-2"), HasSubstr("must not be negative"));
  EXPECT_THAT(with("\"module\"", "\"modul\""), HasSubstr("unknown key 'modul'"));
  for (const char* index : {"[1]", "[-1]", "[0.5]", "0"})
    EXPECT_THAT(with("\"messages\":[0]", std::string("\"messages\":") + index),
                HasSubstr("'messages' must be an array of whole numbers from 0 to below 1"))
        << index;
}

TEST(ReportJson, HoldsEachMessageOnceAndFilesAsAWholeBesideVariants) {
  ValidationReport report;
  for (const char* target : {"spirv", "msl23"})
    for (const std::vector<std::string>& set : subsets({"A", "B"}))
      report.records.push_back(failed(water(set, target), error_at("a.hlsl", 1, 1, "only once")));
  VariantRecord file = failed(water({}, whole_source), error_at("b.shader", 1, 1, "unreadable"));
  file.entry.clear();
  report.records.push_back(file);
  const nlohmann::json json = nlohmann::json::parse(report_json(report));
  EXPECT_EQ(json.at("messages").size(), 2U);
  EXPECT_EQ(json.at("variants").size(), 4U);
  EXPECT_EQ(json.at("variants")[0].at("results").size(), 2U);
  EXPECT_EQ(json.at("sources").size(), 1U);
  EXPECT_EQ(json.at("summary").at("variants"), 4);
  EXPECT_EQ(json.at("summary").at("results"), 9);
}

// The whole run of 24 variants for two targets.
ValidationReport whole_run() {
  ValidationReport report;
  report.fingerprint = "f00d";
  report.seconds = 3.0;
  report.checks = {{"spirv", "glslang"}};
  std::size_t place = 0;
  for (const char* pass : {"ForwardLit", "ShadowCaster", "DepthOnly"})
    for (const std::vector<std::string>& set : subsets({"A", "B", "C"})) {
      for (const char* target : {"spirv", "msl23"}) {
        VariantRecord record = water(set, target);
        record.pass = pass;
        record.place = place;
        record.module = std::to_string(set.size());  // there are four modules in all
        report.records.push_back(set.size() == 3 ? failed(record, error_at("a.hlsl", 1, 1, "no")) : record);
      }
      ++place;
    }
  report.unique = 8;
  return report;
}

std::vector<NamedReport> shards_of(const ValidationReport& whole, unsigned count) {
  std::vector<NamedReport> shards;
  for (unsigned index = 1; index <= count; ++index) {
    ValidationReport shard = whole;
    shard.shard = index;
    shard.shards = count;
    shard.seconds = whole.seconds / count;
    shard.records.clear();
    std::set<std::pair<std::string, std::string>> modules;
    for (const VariantRecord& record : whole.records)
      if (record.place % count == index - 1) {
        shard.records.push_back(record);
        modules.emplace(record.module, record.target);
      }
    shard.unique = modules.size();
    shards.push_back({"shard" + std::to_string(index) + ".json", shard});
  }
  return shards;
}

TEST(MergeReports, ShardsJoinedInAnyOrderAreTheWholeRun) {
  for (const unsigned count : {1U, 2U, 5U}) {
    std::vector<NamedReport> shards = shards_of(whole_run(), count);
    std::reverse(shards.begin(), shards.end());
    ValidationReport merged = merge_reports(shards);
    EXPECT_DOUBLE_EQ(merged.seconds, 3.0);
    merged.seconds = 3.0;
    EXPECT_EQ(report_json(merged), report_json(whole_run())) << count << " shards";
  }
}

std::string refusal(const std::vector<NamedReport>& reports) {
  try {
    merge_reports(reports);
  } catch (const InputError& error) {
    return error.what();
  }
  return "merged";
}

TEST(MergeReports, MissingShardsAreNamed) {
  std::vector<NamedReport> shards = shards_of(whole_run(), 4);
  shards.erase(shards.begin() + 2);
  EXPECT_EQ(refusal(shards), "shard 3/4 is missing\n  run the same command with --shard 3/4");
  shards.erase(shards.begin());
  EXPECT_THAT(refusal(shards), HasSubstr("shards 1/4, 3/4 are missing"));
}

TEST(MergeReports, AShardGivenTwiceIsRefused) {
  std::vector<NamedReport> shards = shards_of(whole_run(), 2);
  shards.push_back({"again.json", shards[0].report});
  EXPECT_THAT(refusal(shards), HasSubstr("again.json: is shard 1/2, as shard1.json is"));
}

TEST(MergeReports, TwoWholeRunsAreRefused) {
  EXPECT_THAT(refusal(std::vector<NamedReport>{{"a.json", whole_run()}, {"b.json", whole_run()}}),
              HasSubstr("b.json: is a whole run, as a.json is"));
}

TEST(MergeReports, ShardsOfDifferentRequestsAreRefused) {
  std::vector<NamedReport> shards = shards_of(whole_run(), 2);
  shards[1].report.fingerprint = "beef";
  EXPECT_THAT(refusal(shards),
              HasSubstr("shard2.json: was made with files or options that differ from those of shard1.json"));
  shards = shards_of(whole_run(), 2);
  shards[1].report.shards = 3;
  EXPECT_THAT(refusal(shards), HasSubstr("shard2.json: is shard 2/3, but shard1.json is shard 1/2"));
}

TEST(MergeReports, ARecordInTwoShardsIsRefused) {
  std::vector<NamedReport> shards = shards_of(whole_run(), 2);
  shards[1].report.records.push_back(shards[0].report.records[2]);
  EXPECT_THAT(
      refusal(shards),
      HasSubstr("shard2.json: contains a result that shard1.json contains, too: Assets/Water.shader, pass "
                "ForwardLit of Custom/Water, fragment entry Frag with B, spirv"));
}

TEST(MergeReports, ChecksOfDifferentMachinesAreBothNamed) {
  std::vector<NamedReport> shards = shards_of(whole_run(), 3);
  shards[1].report.checks["spirv"] = "another glslang";
  EXPECT_EQ(merge_reports(shards).checks.at("spirv"), "glslang; another glslang");
}

}  // namespace
}  // namespace penumbra::validation
