#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "validation/report.h"

namespace penumbra::validation {

namespace {

using Json = nlohmann::ordered_json;

const char* severity_name(hlsl::Severity severity) {
  if (severity == hlsl::Severity::error) return "error";
  return severity == hlsl::Severity::warning ? "warning" : "note";
}

Json diagnostics_json(const std::vector<hlsl::Diagnostic>& diagnostics) {
  Json list = Json::array();
  for (const hlsl::Diagnostic& diagnostic : diagnostics)
    list.push_back({{"file", diagnostic.file},
                    {"line", diagnostic.line},
                    {"column", diagnostic.column},
                    {"severity", severity_name(diagnostic.severity)},
                    {"message", diagnostic.message}});
  return list;
}

Json record_json(const VariantRecord& record) {
  Json json{{"file", record.file},
            {"entry", record.entry},
            {"stage", hlsl::stage_name(record.stage)},
            {"keywords", record.keywords},
            {"target", record.target},
            {"status", status_name(record.status)},
            {"diagnostics", diagnostics_json(record.diagnostics)}};
  if (!record.technique.empty()) json["technique"] = record.technique;
  if (!record.reason.empty()) json["reason"] = record.reason;
  return json;
}

std::string title(const VariantRecord& record) {
  std::string text = record.technique.empty() ? record.file : record.technique;
  text += std::string(", ") + hlsl::stage_name(record.stage) + " entry " + record.entry;
  for (const std::string& keyword : record.keywords) text.append(" +").append(keyword);
  return text + ", " + record.target;
}

// A driver's warnings about emitted text name no line a person wrote; the JSON report has them.
bool worth_printing(const VariantRecord& record, const hlsl::Diagnostic& diagnostic) {
  return diagnostic.severity != hlsl::Severity::warning || record.target == "spirv";
}

std::string totals(const ValidationReport& report) {
  std::string text;
  for (const auto& [target, check] : report.checks)
    text.append(target).append(": ").append(check).append("\n");
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.1f", report.seconds);
  return text + std::to_string(report.records.size()) + " variants (" + std::to_string(report.unique) +
         " unique), " + std::to_string(report.count(VariantStatus::failed)) + " failed, " +
         std::to_string(report.count(VariantStatus::absent)) + " absent, " +
         std::to_string(report.count(VariantStatus::unreached)) + " unreached, " + seconds + " s\n";
}

}  // namespace

const char* status_name(VariantStatus status) {
  switch (status) {
    case VariantStatus::passed:
      return "passed";
    case VariantStatus::failed:
      return "failed";
    case VariantStatus::absent:
      return "absent";
    case VariantStatus::unreached:
      return "unreached";
    case VariantStatus::unchecked:
      break;
  }
  return "unchecked";
}

std::size_t ValidationReport::count(VariantStatus status) const {
  return static_cast<std::size_t>(std::count_if(
      records.begin(), records.end(), [&](const VariantRecord& record) { return record.status == status; }));
}

std::string report_json(const ValidationReport& report) {
  Json json;
  // Nothing is kept from one run to the next yet, so nothing is cached.
  json["summary"] = {{"variants", report.records.size()},
                     {"unique", report.unique},
                     {"failed", report.count(VariantStatus::failed)},
                     {"cached", 0},
                     {"seconds", report.seconds},
                     {"absent", report.count(VariantStatus::absent)},
                     {"unreached", report.count(VariantStatus::unreached)},
                     {"unchecked", report.count(VariantStatus::unchecked)}};
  json["checks"] = report.checks;
  json["variants"] = Json::array();
  for (const VariantRecord& record : report.records) json["variants"].push_back(record_json(record));
  // Shader text in a message may be in any encoding.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_text(const ValidationReport& report) {
  std::string text;
  std::set<std::string> said;  // one mistake in an include fails many variants: it is printed once
  for (const VariantRecord& record : report.records) {
    if (record.status == VariantStatus::absent) {
      text += "absent: " + title(record) + ": " + record.reason + "\n";
      continue;
    }
    if (record.status == VariantStatus::failed) text += "failed: " + title(record) + "\n";
    for (const hlsl::Diagnostic& diagnostic : record.diagnostics)
      if (worth_printing(record, diagnostic) && said.insert(format(diagnostic)).second)
        text += format(diagnostic) + "\n";
  }
  return text + totals(report);
}

}  // namespace penumbra::validation
