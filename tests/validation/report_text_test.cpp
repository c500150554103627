#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "processor_time.h"
#include "sanitized.h"
#include "validation/report_fixture.h"

namespace penumbra::validation {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const hlsl::Diagnostic cause = error_at("Water.hlsl", 3, 9, "unknown variable 'x'");

// The report of all subsets of the keywords, of which those fail that `fails` picks.
template <typename Fails>
ValidationReport report_of(const std::vector<std::string>& keywords, const Fails& fails) {
  ValidationReport report;
  for (const std::vector<std::string>& set : subsets(keywords))
    report.records.push_back(fails(set) ? failed(water(set), cause) : water(set));
  return report;
}

bool has(const std::vector<std::string>& set, const std::string& keyword) {
  return std::find(set.begin(), set.end(), keyword) != set.end();
}

std::string first_line_after_headline(const std::string& text) {
  const std::size_t start = text.find('\n', text.find('\n') + 1) + 1;
  return text.substr(start, text.find('\n', start) - start);
}

TEST(ReportText, OneCauseOfManyVariantsIsOneMessage) {
  const std::string text =
      report_text(report_of({"A", "B", "C", "D", "E", "F", "G"}, [](const auto&) { return true; }));
  EXPECT_THAT(text,
              StartsWith("failed: 1 error\nWater.hlsl:3:9: error: unknown variable 'x'\n"
                         "  pass ForwardLit of Custom/Water, fragment entry Frag, in all 128 variants\n"));
  EXPECT_THAT(text,
              EndsWith("128 variants for 1 target: 128 results (0 unique, 0 cached), 128 failed, 0.0 s\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
}

TEST(ReportText, TheKeywordsThatDecideAreFound) {
  const auto sentence = [](const auto& fails) {
    return first_line_after_headline(report_text(report_of({"A", "B", "C"}, fails)));
  };
  EXPECT_THAT(sentence([](const auto& set) { return has(set, "B"); }),
              EndsWith("in 4 of 8 variants: all with B"));
  EXPECT_THAT(sentence([](const auto& set) { return has(set, "A") && !has(set, "C"); }),
              EndsWith("in 2 of 8 variants: all with A and without C"));
  EXPECT_THAT(sentence([](const auto& set) { return !has(set, "C"); }),
              EndsWith("in 4 of 8 variants: all without C"));
  EXPECT_THAT(sentence([](const auto& set) { return has(set, "A") && (has(set, "B") || has(set, "C")); }),
              EndsWith("in 3 of 8 variants; always with A; for example with A B"));
  EXPECT_THAT(sentence([](const auto& set) { return set.size() == 3; }),
              EndsWith("in 1 of 8 variants: with A B C"));
}

// The report has a keyword of its own for each variant, and an error that so many neighbours share.
ValidationReport report_of_errors(int variants, int neighbours) {
  ValidationReport report;
  for (int i = 0; i < variants; ++i)
    report.records.push_back(failed(water({"K" + std::to_string(i), "G" + std::to_string(i / neighbours)}),
                                    error_at("Water.hlsl", 1, 1, "error " + std::to_string(i / neighbours))));
  return report;
}

// Two of many variants are searched for what they have in common where the many are not too many.
TEST(ReportText, FewOfVeryManyVariantsAreNotToldApart) {
  EXPECT_THAT(report_text(report_of_errors(1024, 2)), HasSubstr("in 2 of 1024 variants: all with G0\n"));
  EXPECT_THAT(report_text(report_of_errors(1026, 2)),
              HasSubstr("in 2 of 1026 variants; for example with G0 K0\n"));
}

TEST(ReportText, ManyErrorsCostTimeInProportionToTheirNumber) {
  const int many = 20'000 / sanitizer_reduction;
  for (const int neighbours : {1, 2}) {
    const ValidationReport report = report_of_errors(many, neighbours);
    const double seconds = processor_seconds([&] {
      EXPECT_THAT(report_text(report), HasSubstr("in " + std::to_string(neighbours) + " of "));
      EXPECT_THAT(report_sarif(report), HasSubstr("\"ofVariants\": " + std::to_string(many)));
    });
    EXPECT_LT(seconds, 20.0) << "what grows with the square takes minutes";
  }
}

TEST(ReportText, AKeywordThatAllVariantsHaveExplainsNothing) {
  ValidationReport report = report_of({"A", "B"}, [](const auto& set) { return has(set, "B"); });
  for (VariantRecord& record : report.records) record.keywords.push_back("ALWAYS");
  EXPECT_THAT(report_text(report), HasSubstr("in 2 of 4 variants: all with B\n"));
}

TEST(ReportText, TargetsOfOneCauseAreFolded) {
  ValidationReport report;
  for (const char* target : {"spirv", "essl310", "glsl450", "msl23"}) {
    const std::string name = target;
    const bool fails = name == "essl310" || name == "glsl450";
    // gl_check() names the emitted text by its target, and its line belongs to nobody.
    report.records.push_back(
        fails ? failed(water({}, name), error_at(name, name == "essl310" ? 4 : 7, 1, "bad"))
              : water({}, name));
  }
  EXPECT_THAT(report_text(report),
              StartsWith("failed: 1 error\nAssets/Water.shader: error: the generated text is rejected: bad\n"
                         "  pass ForwardLit of Custom/Water, fragment entry Frag, "
                         "for essl310, glsl450\n"));
}

TEST(ReportText, SeveralEntryPointsAreCounted) {
  ValidationReport report;
  for (const char* pass : {"ForwardLit", "ShadowCaster", "DepthOnly"}) {
    report.records.push_back(failed(water({}), cause));
    report.records.back().pass = pass;
  }
  EXPECT_THAT(
      report_text(report),
      HasSubstr("  pass ForwardLit of Custom/Water, fragment entry Frag and 2 more, in all 3 variants\n"));
}

TEST(ReportText, LintFindingsNameTheirRule) {
  EXPECT_THAT(report_text(mixed_report()),
              HasSubstr("Assets/Water.shader:30:5: warning: 'colour' is <unset> & \"odd\" [unset-output]\n"));
}

TEST(ReportText, NotesAboutLinesAreFoldedUnlessAskedFor) {
  const ValidationReport report = mixed_report();
  EXPECT_THAT(report_text(report), HasSubstr("\n1 note; --verbose shows it\n"));
  EXPECT_THAT(report_text(report), Not(HasSubstr("kept the body")));
  ReportStyle verbose;
  verbose.verbose = true;
  EXPECT_THAT(report_text(report, verbose),
              HasSubstr("Assets/Water.shader:31:1: note: kept the body of float\n"));
  EXPECT_THAT(report_text(report, verbose), Not(HasSubstr("--verbose")));
}

TEST(ReportText, ReasonsForWhatWasNotJudgedAreSaidOnce) {
  ValidationReport report;
  for (const std::vector<std::string>& set : subsets({"A", "B"})) {
    report.records.push_back(water(set));
    report.records.back().status = VariantStatus::unchecked;
    report.records.back().reason = "needs UnityCG.cginc";
  }
  const std::string text = report_text(report);
  EXPECT_THAT(text, StartsWith("nothing was checked\nunchecked: 4 variants: needs UnityCG.cginc\n"));
  EXPECT_THAT(text, EndsWith("0 failed, 4 unchecked, 0.0 s\n"));
  EXPECT_EQ(text.find("UnityCG", 70), std::string::npos);
  report.records.back().status = VariantStatus::passed;
  EXPECT_THAT(report_text(report), StartsWith("passed\nunchecked: 3 variants: needs UnityCG.cginc\n"));
}

TEST(ReportText, ACrashNamesTheFileThatReproducesIt) {
  EXPECT_THAT(report_text(mixed_report()), HasSubstr("\n  to reproduce: build/crashes/1a2b.hlsl\n"));
}

TEST(ReportText, ErrorsStandLast) {
  const std::string text = report_text(mixed_report());
  EXPECT_LT(text.find("unchecked: "), text.find("warning: "));
  EXPECT_LT(text.rfind("warning: "), text.find("error: "));
}

TEST(ReportText, AFailureWithoutAMessageIsStillSaid) {
  ValidationReport report;
  report.records.push_back(water({}));
  report.records.back().status = VariantStatus::failed;
  EXPECT_THAT(report_text(report),
              StartsWith("failed: 1 error\nAssets/Water.shader: error: failed without a message\n"));
}

TEST(ReportText, ColourIsOnlyThereWhenAskedFor) {
  EXPECT_THAT(report_text(mixed_report()), Not(HasSubstr("\x1b[")));
  ReportStyle style;
  style.colour = true;
  std::string coloured = report_text(mixed_report(), style);
  EXPECT_THAT(coloured, HasSubstr("\x1b[1;31merror: \x1b[0m"));
  for (const char* code : {"\x1b[0m", "\x1b[1m", "\x1b[1;31m", "\x1b[1;35m", "\x1b[1;36m"})
    for (std::size_t at = coloured.find(code); at != std::string::npos; at = coloured.find(code))
      coloured.erase(at, std::string(code).size());
  EXPECT_EQ(coloured, report_text(mixed_report())) << "colour changes no word";
}

TEST(ReportText, AVeryLongLineIsShownAroundItsColumn) {
  hlsl::Diagnostic far = error_at("a.hlsl", 1, 50001, "no such thing");
  far.source_line = std::string(50000, '-') + "HERE" + std::string(50000, '+');
  ValidationReport report;
  report.records.push_back(failed(water({}), far));
  const std::string text = report_text(report);
  EXPECT_LT(text.size(), 1000u);
  EXPECT_THAT(text, StartsWith("failed: 1 error\na.hlsl:1:50001: error: no such thing\n    ...--"));
  const std::size_t excerpt = text.find('\n', text.find('\n') + 1) + 1;
  const std::size_t caret_line = text.find('\n', excerpt) + 1;
  EXPECT_EQ(text.find('^', caret_line) - caret_line, text.find("HERE") - excerpt);
}

TEST(ReportText, ChecksOfAMergedReportHoldNoControlCharacters) {
  ValidationReport report = report_of({}, [](const auto&) { return false; });
  report.checks = {{"spirv", "\x1b[31m\n::error::a"}, {"x\n::error::b", "c"}};
  const std::string text = report_text(report);
  EXPECT_THAT(text, HasSubstr("spirv: \\x1B[31m\\n::error::a\nx\\n::error::b: c\n"));
}

// Reasons, targets, rules and files too come from reports of other machines.
TEST(ReportText, NoTextOfAMergedReportReachesTheTerminalAsItIs) {
  const std::string hostile = "\x1b[2J\x7F\n::error::a";
  ValidationReport report;
  for (const VariantStatus status : {VariantStatus::absent, VariantStatus::unchecked}) {
    report.records.push_back(water({hostile}, hostile));
    report.records.back().status = status;
    report.records.back().reason = hostile;
    report.records.back().file = hostile;
  }
  hlsl::Diagnostic error = error_at(hostile, 1, 1, hostile);
  error.rule = hostile;
  report.records.push_back(failed(water({hostile}, hostile), error));
  report.records.back().reproduction = hostile;
  for (const std::string& text : {report_text(report), report_github(report)}) {
    for (const char c : text)
      EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n')
          << static_cast<int>(c) << " in " << text;
    EXPECT_EQ(text.find('\x7F'), std::string::npos);
    EXPECT_EQ(text.find("\n::error::a"), std::string::npos);
  }
}

TEST(ReportText, TheVerdictStandsFirst) {
  EXPECT_THAT(report_text(mixed_report()), StartsWith("failed: 4 errors, 1 warning\n"));
  ValidationReport report;
  report.records.push_back(water({}));
  EXPECT_THAT(report_text(report), StartsWith("passed\n"));
  report.records[0].diagnostics.push_back(cause);
  report.records[0].diagnostics[0].severity = hlsl::Severity::warning;
  EXPECT_THAT(report_text(report), StartsWith("passed: 1 warning\n"));
  ReportStyle strict;
  strict.werror = true;
  EXPECT_THAT(report_text(report, strict), StartsWith("failed: 1 warning\n"));
  EXPECT_TRUE(fails(report, strict));
  EXPECT_FALSE(fails(report, {}));
}

// Other graphics APIs have another type for `half`.
TEST(ReportText, AMessageThatDiffersInPrecisionIsOne) {
  ValidationReport report;
  for (const char* name : {"half", "min16float"})
    report.records.push_back(
        failed(water({}, name), error_at("a.hlsl", 1, 1, std::string("no F(") + name + "3)")));
  const std::string text = report_text(report);
  EXPECT_THAT(text, HasSubstr("a.hlsl:1:1: error: no F(half3)\n"));
  EXPECT_THAT(text, Not(HasSubstr("F(min16float3)")));
  EXPECT_THAT(text, HasSubstr("for half, min16float\n"));
}

TEST(ReportText, WarningsInPackagesAreNotes) {
  ValidationReport report;
  report.packages = {"/cache/com.x", "Packages/com.y"};
  hlsl::Diagnostic warning = error_at("/cache/com.x/a.hlsl", 1, 1, "of a package");
  warning.severity = hlsl::Severity::warning;
  report.records.push_back(water({}));
  report.records[0].diagnostics = {warning};
  ReportStyle strict;
  strict.werror = true;
  EXPECT_FALSE(fails(report, strict));
  EXPECT_THAT(report_text(report), HasSubstr("passed\n1 note, of which 1 in packages; --verbose shows it\n"));
  EXPECT_THAT(report_sarif(report), Not(HasSubstr("of a package")));
  EXPECT_THAT(report_github(report), Not(HasSubstr("of a package")));
  strict.verbose = true;
  EXPECT_THAT(report_text(report, strict), HasSubstr("/cache/com.x/a.hlsl:1:1: note: of a package\n"));
  EXPECT_THAT(report_sarif(report, strict), HasSubstr("of a package"));
  report.records[0].diagnostics[0].file = "/cache/com.xy/a.hlsl";
  EXPECT_THAT(report_text(report), HasSubstr("/cache/com.xy/a.hlsl:1:1: warning: of a package\n"));
}

// The user's shader does not compile, wherever the line is that a compiler names.
TEST(ReportText, AnErrorInAPackageFailsUnlessItsProgramIsAPackagesToo) {
  ValidationReport report;
  report.packages = {"Packages/com.y"};
  report.records.push_back(failed(water({}), error_at("Packages/com.y/a.hlsl", 1, 1, "no")));
  EXPECT_TRUE(fails(report, {}));
  EXPECT_THAT(report_junit(report), HasSubstr("failures=\"1\""));
  report.records[0].file = "Packages/com.y/A.shader";
  EXPECT_FALSE(fails(report, {}));
  EXPECT_THAT(report_text(report), HasSubstr("1 failed"));
  EXPECT_THAT(report_junit(report), HasSubstr("failures=\"0\""));
  report.packages.clear();
  EXPECT_TRUE(fails(report, {}));
}

// There are as many findings as variants and keywords: the time of each must not grow with all others' pairs.
TEST(ReportText, ThousandsOfKeywordsWithAFindingEachAreWritten) {
  constexpr int count = 1200;
  ValidationReport report;
  for (int i = 0; i < count; ++i) {
    const std::string keyword = "K" + std::to_string(i);
    report.records.push_back(failed(water({keyword}), error_at("a.hlsl", i + 1, 1, "no")));
    report.minimal.push_back({report.records.back().diagnostics[0], {keyword}});
  }
  const std::string text = report_text(report);
  EXPECT_THAT(text, HasSubstr("in 1 of 1200 variants: with K1199\n  enough for it: K1199\n"));
  EXPECT_THAT(report_sarif(report), HasSubstr("in 1 of 1200 variants: with K1199"));
}

TEST(ReportText, AKeywordOfMegabytesIsCut) {
  const std::string keyword(10'000'000, 'K');
  const ValidationReport report = report_of({keyword}, [](const auto& set) { return !set.empty(); });
  const std::string text = report_text(report);
  EXPECT_THAT(text, HasSubstr("in 1 of 2 variants: with KKK"));
  EXPECT_LT(text.size(), 10'000U);
}

}  // namespace
}  // namespace penumbra::validation
