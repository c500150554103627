// Findings of an earlier report do not fail, wherever their lines have moved.
#include "validation/report_baseline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "has_substrs.h"
#include "validation/report_fixture.h"

namespace penumbra::validation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

hlsl::Diagnostic said(int line, const std::string& source_line, const std::string& message = "no 'x'") {
  hlsl::Diagnostic diagnostic = error_at("Water.hlsl", line, 3, message);
  diagnostic.source_line = source_line;
  return diagnostic;
}

ValidationReport report_of(const std::vector<hlsl::Diagnostic>& diagnostics) {
  ValidationReport report;
  report.records.push_back(water({}));
  for (const hlsl::Diagnostic& diagnostic : diagnostics)
    report.records[0] = failed(report.records[0], diagnostic);
  return report;
}

ReportStyle style_with(const ValidationReport& baseline) {
  ReportStyle style;
  style.known = known_findings(baseline, style);
  return style;
}

TEST(ReportBaseline, MovedLinesAreKnownAndOtherTextIsNot) {
  const ValidationReport baseline = report_of({said(3, "return x;")});
  const ValidationReport moved = report_of({said(40, "return x;")});
  EXPECT_FALSE(fails(moved, style_with(baseline)));
  EXPECT_THAT(report_text(moved, style_with(baseline)),
              testing::StartsWith("passed: 1 finding of the baseline\n"));
  EXPECT_TRUE(fails(moved, {}));
  EXPECT_TRUE(fails(report_of({said(3, "return x + 1;")}), style_with(baseline)));
  EXPECT_TRUE(fails(report_of({said(3, "return x;", "no 'y'")}), style_with(baseline)));
}

TEST(ReportBaseline, ASecondEqualFindingIsNew) {
  const ValidationReport baseline = report_of({said(3, "return x;")});
  const ValidationReport twice = report_of({said(3, "return x;"), said(9, "return x;")});
  EXPECT_TRUE(fails(twice, style_with(baseline)));
  EXPECT_FALSE(fails(twice, style_with(twice)));
  EXPECT_THAT(report_text(twice, style_with(baseline)),
              HasSubstrs("failed: 1 error, 1 finding of the baseline\n", "Water.hlsl:9:3: error: no 'x'\n"));
}

TEST(ReportBaseline, FormsTellWhatIsNew) {
  const ValidationReport now = report_of({said(3, "return x;"), said(4, "return y;", "no 'y'")});
  const ReportStyle style = style_with(report_of({said(3, "return x;")}));
  EXPECT_THAT(report_github(now, style), HasSubstr("no 'y'"));
  EXPECT_THAT(report_github(now, style), testing::Not(HasSubstr("no 'x'")));
  EXPECT_THAT(report_junit(now, style), testing::Not(HasSubstr("no 'x'")));
  EXPECT_THAT(report_sarif(now, style),
              HasSubstrs("\"baselineState\": \"unchanged\"", "\"baselineState\": \"new\""));
  EXPECT_THAT(report_sarif(now), testing::Not(HasSubstr("baselineState")));
}

TEST(ReportBaseline, WhatIsNewAndWhatIsGoneIsNamed) {
  const ValidationReport baseline = report_of({said(3, "return x;"), said(7, "return z;", "no 'z'")});
  const ValidationReport now = report_of({said(4, "return x;"), said(8, "return y;", "no 'y'")});
  const FindingComparison comparison = compare_with_baseline(now, baseline, {});
  EXPECT_THAT(comparison.unknown, ElementsAre("Water.hlsl:8:3: error: no 'y'"));
  EXPECT_THAT(comparison.gone, ElementsAre("Water.hlsl:7:3: error: no 'z'"));
  EXPECT_EQ(comparison_text(comparison),
            "not in the baseline: Water.hlsl:8:3: error: no 'y'\n"
            "only in the baseline: Water.hlsl:7:3: error: no 'z'\n"
            "2 findings compared, 1 finding not in the baseline, 1 only there\n");
}

TEST(ReportBaseline, WhatThisRunDidNotCheckIsNotGone) {
  const ValidationReport baseline = report_of({said(3, "return x;")});
  ValidationReport now = report_of({});
  EXPECT_EQ(compare_with_baseline(now, baseline, {}).gone.size(), 1U);
  now.records[0].target = "msl23";
  EXPECT_THAT(compare_with_baseline(now, baseline, {}).gone, IsEmpty());
  now.records[0].target = "spirv";
  now.records[0].file = "Assets/Other.shader";
  EXPECT_THAT(compare_with_baseline(now, baseline, {}).gone, IsEmpty());
  now = report_of({});
  now.shards = 2;
  EXPECT_THAT(compare_with_baseline(now, baseline, {}).gone, IsEmpty());
}

}  // namespace
}  // namespace penumbra::validation
