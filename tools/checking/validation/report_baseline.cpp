#include "validation/report_baseline.h"

#include <algorithm>
#include <utility>

#include "input/baseline_text.h"
#include "input/counted.h"
#include "validation/report_findings.h"

namespace penumbra::validation {
namespace {

// A file's name, and a target for which it has a result.
using Checked = std::set<std::pair<std::string, std::string>>;

std::pair<std::string, std::string> checked(const VariantRecord& record, const ReportStyle& style) {
  return {relative_file(record.file, style), record.target};
}

std::string headline(hlsl::Diagnostic said) {
  said.source_line.clear();
  return format(said);
}

}  // namespace

std::set<std::string> known_findings(const ValidationReport& baseline, const ReportStyle& style) {
  const std::vector<std::string> keys = finding_keys(findings(baseline), style);
  return {keys.begin(), keys.end()};
}

FindingComparison compare_with_baseline(const ValidationReport& report, const ValidationReport& baseline,
                                        const ReportStyle& style) {
  FindingComparison comparison;
  const auto counts = [](const Finding& finding) {
    return finding.diagnostic.severity != hlsl::Severity::note;
  };
  const std::vector<Finding> earlier = findings(baseline);
  const std::vector<std::string> earlier_keys = finding_keys(earlier, style);
  const std::set<std::string> before(earlier_keys.begin(), earlier_keys.end());
  const std::vector<Finding> all = findings(report);
  const std::vector<std::string> keys = finding_keys(all, style);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!counts(all[i])) continue;
    ++comparison.compared;
    if (!before.contains(keys[i])) comparison.unknown.push_back(headline(all[i].diagnostic));
  }
  if (report.shards > 1) return comparison;
  Checked now;
  for (const VariantRecord& record : report.records) now.insert(checked(record, style));
  const std::set<std::string> present(keys.begin(), keys.end());
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    const bool in_reach = std::any_of(
        earlier[i].records.begin(), earlier[i].records.end(),
        [&](std::size_t record) { return now.contains(checked(baseline.records[record], style)); });
    if (counts(earlier[i]) && in_reach && !present.contains(earlier_keys[i]))
      comparison.gone.push_back(headline(earlier[i].diagnostic));
  }
  return comparison;
}

std::string comparison_text(const FindingComparison& comparison) {
  return baseline_lines(comparison.unknown, comparison.gone) + counted(comparison.compared, "finding") +
         " compared, " + baseline_counts("finding", comparison.unknown.size(), comparison.gone.size()) + "\n";
}

}  // namespace penumbra::validation
