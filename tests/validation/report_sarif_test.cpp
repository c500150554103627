// Tests what code scanning relies on; the published schema is another test's affair
// (report_sarif_schema_test.cpp).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "validation/report_fixture.h"

namespace penumbra::validation {
namespace {

using nlohmann::json;
using testing::ElementsAre;

json log_of(const ValidationReport& report, const std::filesystem::path& root = {}) {
  ReportStyle style;
  style.root = root;
  return json::parse(report_sarif(report, style)).at("runs").at(0);
}

const json& result_at(const json& run, const std::string& text) {
  for (const json& result : run.at("results"))
    if (result.at("message").at("text").get<std::string>().find(text) != std::string::npos) return result;
  throw std::out_of_range("no result says " + text);
}

const json& place_of(const json& result) {
  return result.at("locations").at(0).at("physicalLocation");
}

ValidationReport report_of(const hlsl::Diagnostic& diagnostic) {
  ValidationReport report;
  report.records.push_back(failed(water({}), diagnostic));
  return report;
}

TEST(Sarif, IndicesPointAtTheirRulesAndFiles) {
  const json run = log_of(mixed_report());
  EXPECT_EQ(run.at("results").size(), 5u) << "a note about a decision is no alert";
  for (const json& result : run.at("results")) {
    EXPECT_EQ(run.at("tool").at("driver").at("rules").at(result.at("ruleIndex").get<std::size_t>()).at("id"),
              result.at("ruleId"));
    const json& file = place_of(result).at("artifactLocation");
    EXPECT_EQ(run.at("artifacts").at(file.at("index").get<std::size_t>()).at("location").at("uri"),
              file.at("uri"));
  }
}

// A terminal that shows the file interprets no control character of it, and shows no text in another
// direction.
TEST(Sarif, IsAscii) {
  const std::string written = report_sarif(report_of(error_at("\xC3\xA4.hlsl", 1, 1,
                                                              "\xC2\x9B"
                                                              "31m \xE2\x80\xAE")),
                                           {});
  EXPECT_TRUE(std::all_of(written.begin(), written.end(),
                          [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
  EXPECT_THAT(written, testing::HasSubstr("\\u009b31m \\u202e"));
}

TEST(Sarif, RulesAreLintRulesAndKindsOfCompilerMessages) {
  const json run = log_of(mixed_report());
  EXPECT_EQ(result_at(run, "unknown variable").at("ruleId"), "hlsl");
  EXPECT_EQ(result_at(run, "undeclared").at("ruleId"), "target-essl310");
  EXPECT_EQ(result_at(run, "crashed").at("ruleId"), "compiler-crash");
  const json& lint = result_at(run, "<unset>");
  EXPECT_EQ(lint.at("ruleId"), "unset-output");
  EXPECT_EQ(lint.at("level"), "warning");
  const json& rule = run.at("tool").at("driver").at("rules").at(lint.at("ruleIndex").get<std::size_t>());
  EXPECT_EQ(rule.at("shortDescription").at("text"), "An output is unset on some path");
  EXPECT_EQ(log_of(report_of(error_at("", 0, 0, "SPIR-V validation: bad"))).at("results").at(0).at("ruleId"),
            "spirv");
}

TEST(Sarif, OneCauseIsOneResultThatSaysHowManyVariantsHaveIt) {
  const json run = log_of(mixed_report());
  const json& result = result_at(run, "unknown variable");
  EXPECT_EQ(result.at("properties").at("variants"), 2);
  EXPECT_EQ(result.at("properties").at("smallestKeywordSet"), json::array({"_SHADOWS_SOFT"}));
  EXPECT_EQ(place_of(result).at("region").at("startLine"), 12);
  EXPECT_EQ(place_of(result).at("region").at("startColumn"), 17);
}

TEST(Sarif, ARegionIsOnlyThereWithALine) {
  EXPECT_FALSE(place_of(result_at(log_of(mixed_report()), "crashed")).contains("region"));
  const json without_column = log_of(report_of(error_at("a.hlsl", 4, 0, "m")));
  EXPECT_EQ(place_of(without_column.at("results").at(0)).at("region"), json({{"startLine", 4}}));
}

TEST(Sarif, ColumnsCountCharacters) {
  hlsl::Diagnostic diagnostic = error_at("a.hlsl", 1, 8, "m");
  diagnostic.source_line = "/*\xC3\xA9*/ x";
  EXPECT_EQ(place_of(log_of(report_of(diagnostic)).at("results").at(0)).at("region").at("startColumn"), 7);
}

TEST(Sarif, FilesBelowTheRootAreRelativeAndOthersAbsolute) {
  const auto place = [](const std::string& file) {
    return place_of(log_of(report_of(error_at(file, 1, 1, "m")), "/project").at("results").at(0))
        .at("artifactLocation");
  };
  EXPECT_EQ(place("/project/Assets/Water.hlsl").at("uri"), "Assets/Water.hlsl");
  EXPECT_EQ(place("/project/Assets/Water.hlsl").at("uriBaseId"), "%SRCROOT%");
  EXPECT_EQ(place("/packages/a b.hlsl").at("uri"), "file:///packages/a%20b.hlsl");
  EXPECT_FALSE(place("/packages/a b.hlsl").contains("uriBaseId"));
  EXPECT_EQ(place("/projects/x.hlsl").at("uri"), "file:///projects/x.hlsl");
  ReportStyle style;
  style.root = "/project";
  style.folder = "/project/Game";
  const json in_a_subfolder =
      json::parse(report_sarif(report_of(error_at("Assets/a.hlsl", 1, 1, "m")), style));
  EXPECT_EQ(place_of(in_a_subfolder.at("runs").at(0).at("results").at(0)).at("artifactLocation").at("uri"),
            "Game/Assets/a.hlsl");
  EXPECT_EQ(place("./a/../na\xC3\xAFve,1:2%.hlsl").at("uri"), "na%C3%AFve%2C1%3A2%25.hlsl");
}

std::string fingerprint_of(const hlsl::Diagnostic& diagnostic) {
  return log_of(report_of(diagnostic)).at("results").at(0).at("partialFingerprints").at("penumbraFinding/v1");
}

TEST(Sarif, AFingerprintStaysWhenLinesMove) {
  hlsl::Diagnostic diagnostic = error_at("a.hlsl", 4, 2, "m");
  const std::string before = fingerprint_of(diagnostic);
  diagnostic.line = 40;
  EXPECT_EQ(fingerprint_of(diagnostic), before);
  diagnostic.message = "another";
  EXPECT_NE(fingerprint_of(diagnostic), before);
}

TEST(Sarif, EqualFindingsOfOneFileHaveFingerprintsOfTheirOwn) {
  ValidationReport report = report_of(error_at("a.hlsl", 4, 2, "m"));
  report.records[0].diagnostics.push_back(error_at("a.hlsl", 9, 2, "m"));
  const json run = log_of(report);
  std::set<std::string> fingerprints;
  for (const json& result : run.at("results"))
    fingerprints.insert(result.at("partialFingerprints").at("penumbraFinding/v1"));
  EXPECT_EQ(fingerprints.size(), 2u);
}

TEST(Sarif, WhatWasNotJudgedIsANotification) {
  const json run = log_of(mixed_report());
  const json& notifications = run.at("invocations").at(0).at("toolExecutionNotifications");
  ASSERT_EQ(notifications.size(), 1u);
  EXPECT_THAT(notifications.at(0).at("message").at("text").get<std::string>(),
              testing::StartsWith("unchecked: needs HLSLSupport.cginc"));
}

TEST(Sarif, TheSameReportGivesTheSameBytes) {
  EXPECT_EQ(report_sarif(mixed_report()), report_sarif(mixed_report()));
}

}  // namespace
}  // namespace penumbra::validation
