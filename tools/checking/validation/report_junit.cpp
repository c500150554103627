// JUnit XML as GitLab, Jenkins and GitHub's viewers read it: a testsuite per file, a testcase per entry point
// and target, for all variants. Each error is written once: other testcases that have it name the first.
#include <algorithm>
#include <cstdio>
#include <map>
#include <new>
#include <pugixml.hpp>
#include <utility>

#include "input/visible_text.h"
#include "validation/report_findings.h"

namespace penumbra::validation {

namespace {

// Escapes control characters, and those that turn the direction of text. The noncharacters that XML 1.0
// cannot represent (2.2) become U+FFFD; pugixml escapes the rest.
std::string xml_text(std::string_view text) {
  const std::string valid = valid_utf8(text);
  std::string out;
  for (std::size_t begin = 0; begin <= valid.size();) {
    const std::size_t end = std::min(valid.find('\n', begin), valid.size());
    out += (begin > 0 ? "\n" : "") + visible_line(std::string_view(valid).substr(begin, end - begin));
    begin = end + 1;
  }
  for (const std::string_view noncharacter : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
    for (std::size_t at = out.find(noncharacter); at != std::string::npos; at = out.find(noncharacter, at))
      out.replace(at, 3, "\xEF\xBF\xBD");
  return out;
}

// pugixml returns an empty handle when memory has run out.
template <typename Handle>
Handle made(Handle handle) {
  if (!handle) throw std::bad_alloc();
  return handle;
}

pugi::xml_node add_element(pugi::xml_node parent, const char* name) {
  return made(parent.append_child(name));
}

void add_attribute(pugi::xml_node element, const char* name, const std::string& value) {
  if (!made(element.append_attribute(name)).set_value(value.c_str())) throw std::bad_alloc();
}

void add_text(pugi::xml_node element, const std::string& text) {
  if (!made(element.append_child(pugi::node_pcdata)).set_value(text.c_str())) throw std::bad_alloc();
}

// A stream would silently end if memory runs out.
struct TextWriter final : pugi::xml_writer {
  std::string text;
  void write(const void* bytes, std::size_t count) override {
    text.append(static_cast<const char*>(bytes), count);
  }
};

struct TestCase {
  std::string name;
  std::vector<std::size_t> records;
};

struct Suite {
  std::string file;
  std::vector<TestCase> cases;
};

std::string case_name(const VariantRecord& record) {
  return program_title(record) + ", " + record.target;
}

std::vector<Suite> suites_of(const ValidationReport& report) {
  std::vector<Suite> suites;
  std::map<std::string, std::size_t> suite_index;
  std::map<std::pair<std::size_t, std::string>, std::size_t> case_index;
  for (std::size_t i = 0; i < report.records.size(); ++i) {
    const VariantRecord& record = report.records[i];
    const auto [suite_at, suite_is_new] = suite_index.try_emplace(record.file, suites.size());
    if (suite_is_new) suites.push_back({record.file, {}});
    Suite& suite = suites[suite_at->second];
    const std::string name = case_name(record);
    const auto [case_at, case_is_new] = case_index.try_emplace({suite_at->second, name}, suite.cases.size());
    if (case_is_new) suite.cases.push_back({name, {}});
    suite.cases[case_at->second].records.push_back(i);
  }
  return suites;
}

class JunitReport {
 public:
  JunitReport(const ValidationReport& report, const ReportStyle& style)
      : report_(report),
        style_(style),
        findings_(findings(report, style)),
        errors_of_(report.records.size()) {
    for (std::size_t i = 0; i < findings_.size(); ++i)
      if (findings_[i].diagnostic.severity == hlsl::Severity::error && !findings_[i].known)
        for (const std::size_t record : findings_[i].records) errors_of_[record].push_back(i);
  }

  std::string write() {
    pugi::xml_document document;
    pugi::xml_node declaration = made(document.append_child(pugi::node_declaration));
    add_attribute(declaration, "version", "1.0");
    add_attribute(declaration, "encoding", "UTF-8");
    const pugi::xml_node suites = add_element(document, "testsuites");
    add_attribute(suites, "name", "penumbra");
    Counts total;
    for (const Suite& suite : suites_of(report_)) add_suite(suites, suite, total);
    add_counts(suites, total);
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.3f", report_.seconds);
    add_attribute(suites, "time", seconds);
    TextWriter writer;
    document.save(writer, "  ");
    return std::move(writer.text);
  }

 private:
  struct Counts {
    std::size_t tests = 0;
    std::size_t failures = 0;
    std::size_t skipped = 0;
  };

  static void add_counts(pugi::xml_node element, const Counts& count) {
    add_attribute(element, "tests", std::to_string(count.tests));
    add_attribute(element, "failures", std::to_string(count.failures));
    add_attribute(element, "errors", "0");
    add_attribute(element, "skipped", std::to_string(count.skipped));
  }

  void add_suite(pugi::xml_node suites, const Suite& suite, Counts& total) {
    Counts count;
    const std::string file = xml_text(relative_file(suite.file, style_));
    const pugi::xml_node element = add_element(suites, "testsuite");
    add_attribute(element, "name", file);
    for (const TestCase& test : suite.cases) add_case(element, file, test, count);
    add_counts(element, count);
    total.tests += count.tests;
    total.failures += count.failures;
    total.skipped += count.skipped;
  }

  void add_case(pugi::xml_node suite, const std::string& file, const TestCase& test, Counts& count) {
    ++count.tests;
    const pugi::xml_node element = add_element(suite, "testcase");
    add_attribute(element, "name", xml_text(test.name));
    add_attribute(element, "classname", file);
    add_attribute(element, "file", file);
    if (add_failure(element, test)) {
      ++count.failures;
    } else if (const std::string reason = why_skipped(test); !reason.empty()) {
      ++count.skipped;
      add_attribute(add_element(element, "skipped"), "message", xml_text(reason));
    }
  }

  // Returns false when the testcase has no error.
  bool add_failure(pugi::xml_node element, const TestCase& test) {
    std::vector<std::size_t> order;
    std::map<std::size_t, std::size_t> variants_with;
    for (const std::size_t record : test.records)
      for (const std::size_t error : errors_of_[record])
        if (++variants_with[error] == 1) order.push_back(error);
    if (order.empty()) return false;
    std::vector<std::string> places;
    std::string text;
    for (const std::size_t error : order) {
      hlsl::Diagnostic said = findings_[error].diagnostic;
      const auto [first, is_new] = first_case_.try_emplace(error, test.name);
      if (!is_new) {
        said.message = "as in " + first->second;
        said.source_line.clear();
      }
      text += format(said) + "\nin " + std::to_string(variants_with[error]) + " of " +
              counted(test.records.size(), "variant") + "\n";
      said.source_line.clear();
      said.message.clear();
      places.push_back(format(said).substr(0, format(said).rfind(": ")));
    }
    const pugi::xml_node failure = add_element(element, "failure");
    add_attribute(failure, "message", xml_text(shortened(places, ", ", 3)));
    add_attribute(failure, "type", "error");
    add_text(failure, xml_text(text));
    return true;
  }

  std::string why_skipped(const TestCase& test) const {
    std::string reason;
    for (const std::size_t i : test.records) {
      const VariantRecord& record = report_.records[i];
      // The case is combined: some variants were tried, and passed.
      if (record.status == VariantStatus::passed) return {};
      if (!reason.empty()) continue;
      reason = status_name(record.status);
      if (record.status == VariantStatus::failed) {
        reason += ": with errors of packages or of the baseline alone";
      } else {
        reason += record.status == VariantStatus::unreached ? ": there is no SPIR-V to generate it from"
                                                            : ": " + record.reason;
      }
    }
    return reason;
  }

  const ValidationReport& report_;
  const ReportStyle& style_;
  std::vector<Finding> findings_;
  std::vector<std::vector<std::size_t>> errors_of_;  // findings of each record
  std::map<std::size_t, std::string> first_case_;    // by finding: the testcase that has its text
};

}  // namespace

std::string report_junit(const ValidationReport& report, const ReportStyle& style) {
  return JunitReport(report, style).write();
}

}  // namespace penumbra::validation
