#include <algorithm>
#include <nlohmann/json.hpp>

#include "validation/report.h"

namespace penumbra::validation {

namespace {

using Json = nlohmann::ordered_json;

const char* severity_name(hlsl::Severity severity) {
  if (severity == hlsl::Severity::error) return "error";
  return severity == hlsl::Severity::warning ? "warning" : "note";
}

Json diagnostic_json(const hlsl::Diagnostic& diagnostic) {
  Json json{{"file", diagnostic.file},
            {"line", diagnostic.line},
            {"column", diagnostic.column},
            {"severity", severity_name(diagnostic.severity)},
            {"message", diagnostic.message}};
  if (!diagnostic.source_line.empty()) json["source_line"] = diagnostic.source_line;
  if (!diagnostic.rule.empty()) json["rule"] = diagnostic.rule;
  return json;
}

Json diagnostics_json(const std::vector<hlsl::Diagnostic>& diagnostics) {
  Json list = Json::array();
  for (const hlsl::Diagnostic& diagnostic : diagnostics) list.push_back(diagnostic_json(diagnostic));
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
  if (!record.shader.empty()) json["shader"] = record.shader;
  if (!record.pass.empty()) json["pass"] = record.pass;
  if (!record.reason.empty()) json["reason"] = record.reason;
  if (record.cached) json["cached"] = true;
  if (!record.reproduction.empty()) json["reproduction"] = record.reproduction;
  if (!record.module.empty()) json["module"] = record.module;
  if (record.place != 0) json["place"] = record.place;
  return json;
}

}  // namespace

std::string report_json(const ValidationReport& report) {
  const auto cached = std::count_if(report.records.begin(), report.records.end(),
                                    [](const VariantRecord& record) { return record.cached; });
  Json json;
  json["summary"] = {{"variants", report.records.size()},
                     {"unique", report.unique},
                     {"failed", report.count(VariantStatus::failed)},
                     {"cached", cached},
                     {"seconds", report.seconds},
                     {"absent", report.count(VariantStatus::absent)},
                     {"unreached", report.count(VariantStatus::unreached)},
                     {"unchecked", report.count(VariantStatus::unchecked)}};
  if (const FrontEnds counts = front_ends(report); counts.compared != 0)
    json["front_ends"] = {{"compared", counts.compared},
                          {"both_refuse", counts.both},
                          {"fxc_alone_refuses", counts.fxc_alone},
                          {"glslang_alone_refuses", counts.glslang_alone}};
  json["shard"] = {{"index", report.shard}, {"count", report.shards}};
  json["fingerprint"] = report.fingerprint;
  json["checks"] = report.checks;
  json["rules"] = report.rules;
  for (const MinimalKeywords& minimal : report.minimal)
    json["minimal_keywords"].push_back(
        {{"error", diagnostic_json(minimal.error)}, {"keywords", minimal.keywords}});
  json["variants"] = Json::array();
  for (const VariantRecord& record : report.records) json["variants"].push_back(record_json(record));
  // Shader text in a message may be in any encoding.
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace penumbra::validation
