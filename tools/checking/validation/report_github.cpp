// Workflow commands of GitHub Actions: ::error file=,line=,col=,title=::message (docs.github.com, "Workflow
// commands for GitHub Actions"). There is one per finding, because GitHub shows ten of a severity per step.
// The last line is the totals, for the log.
//
// Text is escaped as the toolkit's command.ts does it: % CR LF in messages, and also : , in properties; and
// control characters, which GitHub then shows as %1B.
#include <algorithm>

#include "input/visible_text.h"
#include "validation/report_findings.h"

namespace penumbra::validation {

namespace {

std::string escaped(const std::string& text, std::string_view characters) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string out;
  for (const char c : valid_utf8(text)) {
    const bool control = (static_cast<unsigned char>(c) < 0x20U && c != '\t') || c == 0x7F;
    if (!control && characters.find(c) == std::string_view::npos) {
      out += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      out.append(1, '%').append(1, digits[byte >> 4U]).append(1, digits[byte & 15U]);
    }
  }
  return out;
}

std::string message_text(const std::string& text) {
  return escaped(text, "%\r\n");
}

std::string property(const std::string& text) {
  return escaped(text, "%\r\n:,");
}

const char* command(hlsl::Severity severity) {
  if (severity == hlsl::Severity::error) return "::error ";
  return severity == hlsl::Severity::warning ? "::warning " : "::notice ";
}

std::string annotation(const Finding& finding, const ValidationReport& report, const Variants& variants,
                       const ReportStyle& style) {
  const hlsl::Diagnostic& diagnostic = finding.diagnostic;
  std::string text = command(diagnostic.severity);
  text += "file=" + property(visible(relative_file(diagnostic.file, style)));
  if (diagnostic.line > 0) text += ",line=" + std::to_string(diagnostic.line);
  if (diagnostic.line > 0 && diagnostic.column > 0)
    text += ",col=" + std::to_string(column_in_characters(diagnostic.source_line, diagnostic.column));
  text += ",title=" + property(visible("penumbra: " + finding.rule)) + "::";
  std::string message = visible(diagnostic.message) + "\n" + program_titles(finding, report, variants);
  if (const std::string sentence = fold_sentence(fold_keywords(finding, variants)); !sentence.empty())
    message += ", " + visible(sentence);
  message += ", for " + visible(joined(targets_of(finding, report), ", "));
  return text + message_text(message) + "\n";
}

}  // namespace

std::string report_github(const ValidationReport& report, const ReportStyle& style) {
  const Variants variants(report);
  std::vector<Finding> shown = findings(report, style);
  std::erase_if(shown, [&](const Finding& finding) { return !is_shown(finding, style); });
  // Errors come first: those beyond the tenth are not shown.
  std::stable_sort(shown.begin(), shown.end(), [](const Finding& a, const Finding& b) {
    return a.diagnostic.severity > b.diagnostic.severity;
  });
  std::string text;
  for (const Finding& finding : shown) text += annotation(finding, report, variants, style);
  return text + totals_line(report, variants) + "\n";
}

}  // namespace penumbra::validation
