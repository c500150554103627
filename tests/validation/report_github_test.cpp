// Reads annotations as the runner does: split at commas, then each part unescaped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "validation/report_fixture.h"

namespace penumbra::validation {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Annotation {
  std::string command;
  std::map<std::string, std::string> properties;
  std::string message;
};

std::string unescaped(std::string text) {
  for (const auto& [code, character] :
       {std::pair{"%0D", "\r"}, {"%0A", "\n"}, {"%3A", ":"}, {"%2C", ","}, {"%25", "%"}})
    for (std::size_t at = text.find(code); at != std::string::npos; at = text.find(code, at + 1))
      text.replace(at, 3, character);
  return text;
}

Annotation read(const std::string& line) {
  Annotation annotation;
  const std::size_t blank = line.find(' ');
  const std::size_t end = line.find("::", 2);
  annotation.command = line.substr(2, blank - 2);
  annotation.message = unescaped(line.substr(end + 2));
  std::istringstream properties(line.substr(blank + 1, end - blank - 1));
  for (std::string property; std::getline(properties, property, ',');)
    annotation.properties[property.substr(0, property.find('='))] =
        unescaped(property.substr(property.find('=') + 1));
  return annotation;
}

std::vector<Annotation> annotations(const std::string& text) {
  std::vector<Annotation> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("::")) all.push_back(read(line));
  return all;
}

TEST(GithubAnnotations, StandAtTheirPlaceWithOneLineEach) {
  const Annotation first = annotations(report_github(mixed_report())).at(0);
  EXPECT_EQ(first.command, "error");
  EXPECT_EQ(first.properties.at("file"), "Assets/Water.hlsl");
  EXPECT_EQ(first.properties.at("line"), "12");
  EXPECT_EQ(first.properties.at("col"), "17");
  EXPECT_EQ(first.properties.at("title"), "penumbra: hlsl");
  EXPECT_THAT(first.message, StartsWith("unknown variable 'depth'\npass ForwardLit of Custom/Water"));
}

TEST(GithubAnnotations, NameBothProgramsThatHaveTheFinding) {
  ValidationReport report;
  const hlsl::Diagnostic shared = error_at("Assets/Water.hlsl", 12, 17, "unknown variable 'depth'");
  VariantRecord vertex = water({});
  vertex.stage = hlsl::Stage::vertex;
  vertex.entry = "Vert";
  report.records = {failed(vertex, shared), failed(water({}), shared)};
  EXPECT_THAT(annotations(report_github(report)).at(0).message,
              HasSubstr("vertex entry Vert and pass ForwardLit of Custom/Water, fragment entry Frag"));
}

TEST(GithubAnnotations, NoTextBreaksOutOfItsPlace) {
  ValidationReport report;
  const std::string hostile = "a,line=9::b\r\n::error::c %0A";
  report.records.push_back(failed(water({}), error_at(hostile, 1, 1, hostile)));
  const std::string text = report_github(report);
  const std::vector<Annotation> all = annotations(text);
  ASSERT_EQ(all.size(), 1u) << text;
  EXPECT_EQ(all[0].properties.at("line"), "1");
  EXPECT_EQ(all[0].properties.at("file"), "a,line=9::b\\r\\n::error::c %0A");
  EXPECT_THAT(all[0].message, StartsWith("a,line=9::b\\r\\n::error::c %0A"));
}

TEST(GithubAnnotations, NoFileOrRuleTurnsTheDirectionOfText) {
  const std::string turned =
      "a\xE2\x80\xAE\xC2\x85"
      "b";
  hlsl::Diagnostic error = error_at(turned, 1, 1, "no");
  error.rule = turned;
  ValidationReport report;
  report.records.push_back(failed(water({}), error));
  const Annotation annotation = annotations(report_github(report)).at(0);
  EXPECT_EQ(annotation.properties.at("file"),
            "a\\u202E\\x85"
            "b");
  EXPECT_EQ(annotation.properties.at("title"),
            "penumbra: a\\u202E\\x85"
            "b");
}

TEST(GithubAnnotations, ErrorsComeFirstAndNotesAboutLinesNotAtAll) {
  std::vector<std::string> commands;
  for (const Annotation& annotation : annotations(report_github(mixed_report())))
    commands.push_back(annotation.command);
  EXPECT_THAT(commands, testing::ElementsAre("error", "error", "error", "error", "warning"));
}

TEST(GithubAnnotations, FilesAreRelativeToTheRoot) {
  ValidationReport report;
  report.records.push_back(failed(water({}), error_at("/project/Assets/A.hlsl", 1, 1, "no")));
  ReportStyle style;
  style.root = "/project";
  EXPECT_EQ(annotations(report_github(report, style)).at(0).properties.at("file"), "Assets/A.hlsl");
}

TEST(GithubAnnotations, TheLogEndsWithTheTotals) {
  EXPECT_THAT(report_github(mixed_report()), testing::EndsWith(" unchecked, 1.2 s\n"));
}

}  // namespace
}  // namespace penumbra::validation
