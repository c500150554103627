// JUnit XML as GitLab, Jenkins and GitHub's viewers read it: a testsuite a file, a testcase a variant and
// target. Of a run too large for their pages it is a testcase an entry point and target, with its variants
// folded.
#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "validation/report_findings.h"
#include "validation/report_place.h"

namespace penumbra::validation {

namespace {

constexpr std::size_t most_cases = 5000;  // GitLab's page of a test report holds some thousands

// For text and quoted attributes; what XML 1.0 cannot hold at all (2.2) becomes U+FFFD.
std::string xml(std::string_view text) {
  std::string out;
  for (const char c : valid_utf8(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\n':
        out += "&#10;";
        break;
      case '\t':
        out += "&#9;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20U ? std::string("\xEF\xBF\xBD") : std::string(1, c);
    }
  }
  for (const std::string_view noncharacter : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
    for (std::size_t at = out.find(noncharacter); at != std::string::npos; at = out.find(noncharacter, at))
      out.replace(at, 3, "\xEF\xBF\xBD");
  return out;
}

struct TestCase {
  std::string name;
  std::vector<std::size_t> records;  // one, or all of an entry point for a target
};

struct Suite {
  std::string file;
  std::vector<TestCase> cases;
};

std::string case_name(const VariantRecord& record, bool folded) {
  std::string name = program_title(record) + ", " + record.target;
  if (!folded && !record.keywords.empty()) name += " [" + joined(record.keywords, " ") + "]";
  return name;
}

std::vector<Suite> suites_of(const ValidationReport& report) {
  const bool folded = report.records.size() > most_cases;
  std::vector<Suite> suites;
  std::map<std::string, std::size_t> suite_index;
  std::map<std::pair<std::size_t, std::string>, std::size_t> case_index;
  for (std::size_t i = 0; i < report.records.size(); ++i) {
    const VariantRecord& record = report.records[i];
    const auto [suite_at, suite_is_new] = suite_index.try_emplace(record.file, suites.size());
    if (suite_is_new) suites.push_back({record.file, {}});
    Suite& suite = suites[suite_at->second];
    const std::string name = case_name(record, folded);
    const auto [case_at, case_is_new] = case_index.try_emplace({suite_at->second, name}, suite.cases.size());
    if (case_is_new) suite.cases.push_back({name, {}});
    suite.cases[case_at->second].records.push_back(i);
  }
  return suites;
}

class JunitReport {
 public:
  JunitReport(const ValidationReport& report, const ReportStyle& style) : report_(report), style_(style) {}

  std::string write() {
    std::string suites;
    for (const Suite& suite : suites_of(report_)) suites += write_suite(suite);
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.3f", report_.seconds);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"penumbra\"" + counts(total_) +
           " time=\"" + seconds + "\">\n" + suites + "</testsuites>\n";
  }

 private:
  struct Counts {
    std::size_t tests = 0;
    std::size_t failures = 0;
    std::size_t skipped = 0;
  };

  static std::string counts(const Counts& count) {
    return " tests=\"" + std::to_string(count.tests) + "\" failures=\"" + std::to_string(count.failures) +
           "\" errors=\"0\" skipped=\"" + std::to_string(count.skipped) + "\"";
  }

  std::string write_suite(const Suite& suite) {
    Counts count;
    std::string cases;
    const std::string file = relative_file(suite.file, style_);
    for (const TestCase& test : suite.cases) cases += write_case(file, test, count);
    total_.tests += count.tests;
    total_.failures += count.failures;
    total_.skipped += count.skipped;
    return "  <testsuite name=\"" + xml(file) + "\"" + counts(count) + ">\n" + cases + "  </testsuite>\n";
  }

  std::string write_case(const std::string& file, const TestCase& test, Counts& count) const {
    ++count.tests;
    const std::string start = "    <testcase name=\"" + xml(test.name) + "\" classname=\"" + xml(file) +
                              "\" file=\"" + xml(file) + "\"";
    if (const std::string failure = write_failure(test); !failure.empty()) {
      ++count.failures;
      return start + ">\n" + failure + "    </testcase>\n";
    }
    if (const std::string reason = why_skipped(test); !reason.empty()) {
      ++count.skipped;
      return start + "><skipped message=\"" + xml(reason) + "\"/></testcase>\n";
    }
    return start + "/>\n";
  }

  // Each message once, with how many of the folded variants have it.
  std::string write_failure(const TestCase& test) const {
    std::vector<std::pair<const hlsl::Diagnostic*, std::size_t>> told;
    std::map<std::string, std::size_t> index;
    std::size_t failed = 0;
    for (const std::size_t i : test.records) {
      if (report_.records[i].status != VariantStatus::failed) continue;
      ++failed;
      for (const hlsl::Diagnostic& diagnostic : report_.records[i].diagnostics) {
        if (diagnostic.severity != hlsl::Severity::error) continue;
        const auto [at, is_new] = index.try_emplace(format(diagnostic), told.size());
        if (is_new) told.emplace_back(&diagnostic, 0);
        ++told[at->second].second;
      }
    }
    if (failed == 0) return {};
    const std::string first = told.empty() ? "failed without a message" : told.front().first->message;
    std::string text;
    for (const auto& [diagnostic, count] : told) {
      text += format(*diagnostic) + "\n";
      if (test.records.size() > 1)
        text += "in " + std::to_string(count) + " of " + std::to_string(test.records.size()) + " variants\n";
    }
    return "      <failure message=\"" + xml(first) + "\" type=\"error\">" + xml(text) + "</failure>\n";
  }

  std::string why_skipped(const TestCase& test) const {
    std::string reason;
    for (const std::size_t i : test.records) {
      const VariantRecord& record = report_.records[i];
      if (record.status == VariantStatus::passed) return {};  // folded: some were tried, and passed
      if (!reason.empty()) continue;
      reason = status_name(record.status);
      reason += record.status == VariantStatus::unreached ? ": there is no SPIR-V to generate it from"
                                                          : ": " + record.reason;
    }
    return reason;
  }

  const ValidationReport& report_;
  const ReportStyle& style_;
  Counts total_;
};

}  // namespace

std::string report_junit(const ValidationReport& report, const ReportStyle& style) {
  return JunitReport(report, style).write();
}

}  // namespace penumbra::validation
