// Reads the XML as libxml2 does, through xmllint.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platform/child_process.h"
#include "shaders/shader_files.h"
#include "validation/report_fixture.h"

namespace penumbra::validation {
namespace {

using testing::HasSubstr;

class Junit : public testing::Test {
 protected:
  // The answer to an XPath question, or what is wrong with the XML.
  std::string ask(const ValidationReport& report, const std::string& xpath) {
    ReportStyle style;
    style.root = "/project";
    const std::filesystem::path file = files_.write("report.xml", report_junit(report, style));
    platform::ChildCommand command;
    command.program = "xmllint";
    command.arguments = {"--nonet", "--xpath", xpath, file.string()};
    platform::ChildResult result = platform::run_child(command);
    if (!result.succeeded()) return result.errors;
    while (!result.output.empty() && result.output.back() == '\n') result.output.pop_back();
    return result.output;
  }

  shaders::ShaderFiles files_;
};

TEST_F(Junit, IsXmlWhateverTheTextHolds) {
  EXPECT_EQ(ask(mixed_report(), "name(/*)"), "testsuites");
  const std::string message = ask(mixed_report(), "string(//failure[contains(text(), 'byte')])");
  EXPECT_THAT(message, HasSubstr("byte \\xFF, control \\x01, ]]> % \\r\\nand a second line"));
}

TEST_F(Junit, EveryByteOfAMessageSurvivesOrIsReplaced) {
  ValidationReport report;
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  // These are no characters of XML.
  all += "\xEF\xBF\xBE \xEF\xBF\xBF \xED\xA0\x80 \xF4\x90\x80\x80 \xC0\xAF";
  report.records.push_back(failed(water({all}), error_at(all, 1, 1, all)));
  EXPECT_EQ(ask(report, "count(//failure)"), "1");
  EXPECT_THAT(ask(report, "string(//failure)"), HasSubstr(" !\"#$%&'()*+,-./0123456789:;<=>?@ABC"));
}

TEST_F(Junit, ATestcaseIsAnEntryPointAndTarget) {
  const ValidationReport report = mixed_report();
  EXPECT_EQ(ask(report, "count(//testcase)"), "3");
  EXPECT_EQ(ask(report, "count(//testcase[failure])"), "2");
  EXPECT_EQ(ask(report, "string(//testcase[failure][1]/@name)"),
            "pass ForwardLit of Custom/Water, fragment entry Frag, spirv");
  EXPECT_THAT(ask(report, "string(//testcase[failure][1]/failure/@message)"),
              testing::StartsWith("Assets/Water.hlsl:12:17: error"));
}

TEST_F(Junit, AnErrorIsWrittenOnce) {
  ValidationReport report;
  const hlsl::Diagnostic shared = error_at("Water.hlsl", 12, 17, "unknown variable 'depth'");
  for (const char* pass : {"ForwardLit", "DepthOnly"}) {
    report.records.push_back(failed(water({}), shared));
    report.records.back().pass = pass;
  }
  EXPECT_EQ(ask(report, "count(//failure[contains(., 'unknown variable')])"), "1");
  EXPECT_EQ(
      ask(report, "string(//testcase[2]/failure)"),
      "Water.hlsl:12:17: error: as in pass ForwardLit of Custom/Water, fragment entry Frag, spirv\nin 1 of 1 "
      "variant");
}

TEST_F(Junit, CountsAgreeWithTheCases) {
  const ValidationReport report = mixed_report();
  for (const char* level : {"/testsuites", "/testsuites/testsuite[1]"}) {
    const std::string at = level;
    EXPECT_EQ(ask(report, at + "/@tests = count(" + at + "//testcase)"), "true");
    EXPECT_EQ(ask(report, at + "/@failures = count(" + at + "//failure)"), "true");
    EXPECT_EQ(ask(report, at + "/@skipped = count(" + at + "//skipped)"), "true");
  }
}

TEST_F(Junit, ASuiteIsAFileRelativeToTheRoot) {
  ValidationReport report;
  for (const char* file : {"/project/Assets/A.shader", "/project/Assets/B.shader", "/elsewhere/C.shader"}) {
    report.records.push_back(water({}));
    report.records.back().file = file;
  }
  EXPECT_EQ(ask(report, "count(//testsuite)"), "3");
  EXPECT_EQ(ask(report, "string(//testsuite[2]/@name)"), "Assets/B.shader");
  EXPECT_EQ(ask(report, "string(//testsuite[3]/@name)"), "/elsewhere/C.shader");
}

TEST_F(Junit, WhatWasNotJudgedIsSkippedWithItsReason) {
  ValidationReport report = mixed_report();
  std::erase_if(report.records,
                [](const VariantRecord& record) { return record.status != VariantStatus::unchecked; });
  EXPECT_THAT(ask(report, "string(//skipped/@message)"), HasSubstr("unchecked: needs HLSLSupport.cginc"));
}

TEST_F(Junit, VariantsAreCounted) {
  ValidationReport report;
  for (int i = 0; i < 6000; ++i) {
    VariantRecord record = water({"K" + std::to_string(i)}, i % 2 == 0 ? "spirv" : "msl23");
    report.records.push_back(i % 100 == 0 ? failed(record, error_at("a.hlsl", 1, 1, "no")) : record);
  }
  EXPECT_EQ(ask(report, "count(//testcase)"), "2");
  EXPECT_EQ(ask(report, "count(//failure)"), "1");
  EXPECT_THAT(ask(report, "string(//failure)"), HasSubstr("in 60 of 3000 variants"));
}

}  // namespace
}  // namespace penumbra::validation
