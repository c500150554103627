// The report for people: the verdict, reasons for unchecked results, warnings, errors, and a line of totals
// at the end, where a terminal stops scrolling.
#include <algorithm>
#include <map>
#include <utility>

#include "input/visible_text.h"
#include "validation/report.h"
#include "validation/report_findings.h"

namespace penumbra::validation {

namespace {

constexpr const char* bold = "\x1b[1m";
constexpr const char* plain = "\x1b[0m";

const char* colour_of(hlsl::Severity severity) {
  if (severity == hlsl::Severity::error) return "\x1b[1;31m";
  return severity == hlsl::Severity::warning ? "\x1b[1;35m" : "\x1b[1;36m";
}

std::string painted(const std::string& text, const char* colour, const ReportStyle& style) {
  return style.colour ? colour + text + plain : text;
}

// Returns the source line and its caret.
std::string excerpt(const hlsl::Diagnostic& diagnostic) {
  const std::string text =
      hlsl::format({{}, 1, diagnostic.column, hlsl::Severity::note, {}, diagnostic.source_line, {}});
  const std::size_t end_of_headline = text.find('\n');
  return end_of_headline == std::string::npos ? "" : text.substr(end_of_headline);
}

// The line is that of a compiler, so that editors find the place: file:line:column: severity: message [rule].
std::string headline(const hlsl::Diagnostic& diagnostic, const ReportStyle& style) {
  hlsl::Diagnostic place = diagnostic;
  place.source_line.clear();
  place.message.clear();
  std::string text = format(place);  // "file:line:column: severity: "
  const std::size_t severity = text.rfind(' ', text.size() - 2) + 1;
  text = painted(text.substr(0, severity), bold, style) +
         painted(text.substr(severity), colour_of(diagnostic.severity), style) +
         painted(visible(diagnostic.message), bold, style);
  return diagnostic.rule.empty() ? text : text + " [" + visible(diagnostic.rule) + "]";
}

class TextReport {
 public:
  TextReport(const ValidationReport& report, const ReportStyle& style)
      : report_(report), style_(style), variants_(report), findings_(findings(report, style)) {
    for (const MinimalKeywords& one : report.minimal) minimal_.try_emplace(format(one.error), &one.keywords);
  }

  std::string write() {
    std::string text = verdict() + absences() + unchecked();
    for (const hlsl::Severity severity :
         {hlsl::Severity::note, hlsl::Severity::warning, hlsl::Severity::error})
      for (const Finding& finding : findings_)
        if (finding.diagnostic.severity == severity && is_shown(finding, style_)) text += block(finding);
    return text + not_shown() + totals();
  }

 private:
  std::string verdict() const {
    const Verdict verdict = verdict_of(findings_, style_);
    // "passed" above variants of which none was compiled would look like a check.
    const bool checked = report_.count(VariantStatus::passed) + report_.count(VariantStatus::failed) > 0;
    if (!verdict.failed && !checked && !report_.records.empty())
      return painted("nothing was checked", bold, style_) + "\n";
    return painted(verdict.text, verdict.failed ? colour_of(hlsl::Severity::error) : bold, style_) + "\n";
  }

  std::string not_shown() const {
    std::size_t notes = 0;
    std::size_t in_packages = 0;
    for (const Finding& finding : findings_) {
      if (is_shown(finding, style_) || finding.known) continue;
      ++notes;
      in_packages += finding.in_package ? 1 : 0;
    }
    if (notes == 0) return {};
    std::string text = counted(notes, "note");
    if (in_packages != 0) text += ", of which " + std::to_string(in_packages) + " in packages";
    return text + (notes == 1 ? "; --verbose shows it\n" : "; --verbose shows them\n");
  }

  std::string block(const Finding& finding) const {
    std::string text = headline(finding.diagnostic, style_) + excerpt(finding.diagnostic) + "\n";
    text += "  " + program_titles(finding, report_, variants_);
    if (const std::string sentence = fold_sentence(fold_keywords(finding, variants_)); !sentence.empty())
      text += ", " + visible(sentence);
    const std::vector<std::string> targets = targets_of(finding, report_);
    if (targets != std::vector<std::string>{"spirv"} && targets != std::vector<std::string>{whole_source})
      text += ", for " + visible(joined(targets, ", "));
    return text + "\n" + minimal(finding) + reproduction(finding);
  }

  std::string minimal(const Finding& finding) const {
    if (minimal_.empty()) return {};
    const auto found = minimal_.find(format(finding.diagnostic));
    if (found == minimal_.end()) return {};
    return found->second->empty() ? "  without any keyword as well\n"
                                  : "  enough for it: " + visible(joined(*found->second, " ")) + "\n";
  }

  std::string reproduction(const Finding& finding) const {
    if (finding.diagnostic.severity != hlsl::Severity::error) return {};
    for (const std::size_t record : finding.records)
      if (const std::string& file = report_.records[record].reproduction; !file.empty())
        return "  to reproduce: " + visible(file) + "\n";
    return {};
  }

  struct Reason {
    std::set<std::size_t> variants;
    std::vector<std::string> targets;
  };

  // Lists the records of one status, grouped by owner and by reason, in order of appearance.
  template <typename Title>
  std::string by_reason(VariantStatus status, const Title& line_of) const {
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, Reason> reasons;
    for (std::size_t i = 0; i < report_.records.size(); ++i) {
      const VariantRecord& record = report_.records[i];
      if (record.status != status) continue;
      const std::string owner = status == VariantStatus::unchecked ? std::string()
                                : record.technique.empty()         ? record.file
                                                                   : record.technique;
      const auto [at, is_new] = reasons.try_emplace({owner, record.reason});
      if (is_new) order.push_back(at->first);
      at->second.variants.insert(variants_.of_record(i));
      if (std::find(at->second.targets.begin(), at->second.targets.end(), record.target) ==
          at->second.targets.end())
        at->second.targets.push_back(record.target);
    }
    std::string text;
    for (const auto& key : order) text += line_of(key.first, key.second, reasons.at(key)) + "\n";
    return text;
  }

  std::string absences() const {
    return by_reason(VariantStatus::absent,
                     [](const std::string& owner, const std::string& reason, const Reason& who) {
                       return "absent: " + visible(owner) + ", " + visible(joined(who.targets, ", ")) + ": " +
                              visible(reason) + " (" + counted(who.variants.size(), "variant") + ")";
                     });
  }

  std::string unchecked() const {
    return by_reason(VariantStatus::unchecked,
                     [](const std::string&, const std::string& reason, const Reason& who) {
                       const bool whole = who.targets.front() == whole_source;
                       return "unchecked: " + counted(who.variants.size(), whole ? "program" : "variant") +
                              ": " + visible(reason);
                     });
  }

  std::string totals() const {
    std::string text;
    for (const auto& [target, check] : report_.checks)
      text.append(visible(target)).append(": ").append(visible(check)).append("\n");
    if (const std::string compared = text_of(front_ends(report_)); !compared.empty())
      text.append(compared).append("\n");
    const bool failed = report_.count(VariantStatus::failed) != 0;
    const char* colour = failed ? colour_of(hlsl::Severity::error) : bold;
    return text + painted(totals_line(report_, variants_), colour, style_) + "\n";
  }

  const ValidationReport& report_;
  const ReportStyle& style_;
  Variants variants_;
  std::vector<Finding> findings_;
  std::map<std::string, const std::vector<std::string>*> minimal_;  // keywords by the error as printed
};

}  // namespace

std::string report_text(const ValidationReport& report, const ReportStyle& style) {
  return TextReport(report, style).write();
}

}  // namespace penumbra::validation
