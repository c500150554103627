// SARIF 2.1.0 (OASIS Standard, section numbers below). There is one result per finding: one per variant would
// be too many for code scanning. URIs are relative to %SRCROOT% (3.14.14), so that the log is the same on
// every machine.
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "validation/report_findings.h"

namespace penumbra::validation {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* source_root = "%SRCROOT%";

const char* level_of(hlsl::Severity severity) {  // 3.27.10
  if (severity == hlsl::Severity::error) return "error";
  return severity == hlsl::Severity::warning ? "warning" : "note";
}

std::string describe(const std::string& rule, const ValidationReport& report) {
  if (const auto known = report.rules.find(rule); known != report.rules.end()) return known->second;
  if (rule == "hlsl") return "The HLSL compiler rejects the source or warns about it";
  if (rule == "spirv") return "The compiled module is not valid SPIR-V";
  if (rule == compiler_crash)
    return "A compiler crashes on the source: a failure of penumbra, not of the shader";
  if (rule == compiler_limit) return "A compiler reaches its limit of time or memory on the source";
  const std::string target = "target-";
  if (rule.starts_with(target)) return "The shader cannot be compiled for " + rule.substr(target.size());
  return "Finds what Unity's own compilers reject or what costs speed: " + rule;
}

class SarifLog {
 public:
  SarifLog(const ValidationReport& report, const ReportStyle& style)
      : report_(report), style_(style), variants_(report) {}

  std::string write() {
    Json results = Json::array();
    const std::vector<Finding> all = findings(report_, style_);
    const std::vector<std::string> keys = finding_keys(all, style_);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (style_.known ? !all[i].in_package || style_.verbose : is_shown(all[i], style_))
        results.push_back(result(all[i], keys[i]));
    Json run;
    run["tool"]["driver"] = {{"name", "penumbra"}, {"rules", rules_}};
    run["invocations"] = Json::array({invocation()});
    run["originalUriBaseIds"][source_root]["description"]["text"] = "The folder in which the check ran";
    run["artifacts"] = artifacts_;
    run["columnKind"] = "unicodeCodePoints";
    run["results"] = std::move(results);
    const Json log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                   {"version", "2.1.0"},
                   {"runs", Json::array({std::move(run)})}};
    return log.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
  }

 private:
  Json result(const Finding& finding, const std::string& key) {
    const hlsl::Diagnostic& diagnostic = finding.diagnostic;
    const KeywordFold fold = fold_keywords(finding, variants_);
    Json json;
    json["ruleId"] = finding.rule;
    json["ruleIndex"] = rule_index(finding.rule);
    json["level"] = level_of(diagnostic.severity);
    json["message"]["text"] = message(finding, fold);
    json["locations"] = Json::array({location(diagnostic)});
    json["partialFingerprints"]["penumbraFinding/v1"] = key;                        // 3.27.17
    if (style_.known) json["baselineState"] = finding.known ? "unchanged" : "new";  // 3.27.24
    json["properties"] = {{"variants", fold.in},
                          {"ofVariants", fold.of},
                          {"targets", targets_of(finding, report_)},
                          {"smallestKeywordSet", fold.example}};
    return json;
  }

  // The message is plain text in complete sentences, which can be read on its own in a list and in an
  // annotation.
  std::string message(const Finding& finding, const KeywordFold& fold) const {
    std::string text = finding.diagnostic.message + " (" + program_titles(finding, report_, variants_);
    if (const std::string sentence = fold_sentence(fold); !sentence.empty()) text += ", " + sentence;
    const std::vector<std::string> targets = targets_of(finding, report_);
    if (targets != std::vector<std::string>{"spirv"}) text += ", for " + joined(targets, ", ");
    return text + ")";
  }

  Json location(const hlsl::Diagnostic& diagnostic) {
    const std::string file = relative_file(diagnostic.file, style_);
    Json place;
    place["artifactLocation"] = artifact_location(file);
    place["artifactLocation"]["index"] = artifact_index(file);
    if (diagnostic.line > 0) {
      place["region"]["startLine"] = diagnostic.line;
      if (diagnostic.column > 0)
        place["region"]["startColumn"] = column_in_characters(diagnostic.source_line, diagnostic.column);
      if (!diagnostic.source_line.empty() && diagnostic.source_line.size() < 1000)
        place["region"]["snippet"]["text"] = diagnostic.source_line;
    }
    return {{"physicalLocation", std::move(place)}};
  }

  // Only a relative reference has a base (3.4.4).
  static Json artifact_location(const std::string& file) {
    Json json{{"uri", uri_of(file)}};
    if (!std::filesystem::path(file).is_absolute()) json["uriBaseId"] = source_root;
    return json;
  }

  std::size_t artifact_index(const std::string& file) {
    const auto [at, is_new] = artifact_indices_.try_emplace(file, artifacts_.size());
    if (is_new) artifacts_.push_back({{"location", artifact_location(file)}});
    return at->second;
  }

  std::size_t rule_index(const std::string& rule) {
    const auto [at, is_new] = rule_indices_.try_emplace(rule, rules_.size());
    if (is_new) rules_.push_back({{"id", rule}, {"shortDescription", {{"text", describe(rule, report_)}}}});
    return at->second;
  }

  // Results that could not be determined concern the run (3.20), not the shader.
  Json invocation() const {
    Json json{{"executionSuccessful", true}};
    std::set<std::string> reasons;
    for (const VariantRecord& record : report_.records) {
      const bool unchecked = record.status == VariantStatus::unchecked;
      if ((!unchecked && record.status != VariantStatus::absent) || !reasons.insert(record.reason).second)
        continue;
      json["toolExecutionNotifications"].push_back(
          {{"level", unchecked ? "warning" : "note"},
           {"message", {{"text", std::string(status_name(record.status)) + ": " + record.reason}}}});
    }
    return json;
  }

  const ValidationReport& report_;
  const ReportStyle& style_;
  Variants variants_;
  Json rules_ = Json::array();
  Json artifacts_ = Json::array();
  std::map<std::string, std::size_t> rule_indices_;
  std::map<std::string, std::size_t> artifact_indices_;
};

}  // namespace

std::string report_sarif(const ValidationReport& report, const ReportStyle& style) {
  return SarifLog(report, style).write();
}

}  // namespace penumbra::validation
