// The report for programs. Each message is written once, and results name it by its number, since thousands
// of results may have the same messages. A message, a variant with its results, a file or program as a whole
// is a line.
#include <map>
#include <nlohmann/json.hpp>

#include "validation/report.h"
#include "validation/report_findings.h"

namespace penumbra::validation {

namespace {

using Json = nlohmann::ordered_json;

// Shader text in a message may be in any encoding.
std::string line_of(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

const char* severity_name(hlsl::Severity severity) {
  if (severity == hlsl::Severity::error) return "error";
  return severity == hlsl::Severity::warning ? "warning" : "note";
}

Json message_json(const hlsl::Diagnostic& diagnostic) {
  Json json{{"file", diagnostic.file},
            {"line", diagnostic.line},
            {"column", diagnostic.column},
            {"severity", severity_name(diagnostic.severity)},
            {"message", diagnostic.message}};
  if (!diagnostic.source_line.empty()) json["source_line"] = diagnostic.source_line;
  if (!diagnostic.rule.empty()) json["rule"] = diagnostic.rule;
  return json;
}

// Lines, each once, in the order in which they are added.
class Lines {
 public:
  std::size_t add(std::string line) {
    const auto [at, is_new] = numbers_.try_emplace(std::move(line), order_.size());
    if (is_new) order_.push_back(&at->first);
    return at->second;
  }
  std::vector<std::string> all() const {
    std::vector<std::string> lines;
    for (const std::string* line : order_) lines.push_back(*line);
    return lines;
  }

 private:
  std::map<std::string, std::size_t> numbers_;
  std::vector<const std::string*> order_;
};

Json variant_json(const VariantRecord& record) {
  Json json{{"file", record.file}};
  if (!record.technique.empty()) json["technique"] = record.technique;
  if (!record.shader.empty()) json["shader"] = record.shader;
  if (!record.pass.empty()) json["pass"] = record.pass;
  json["entry"] = record.entry;
  json["stage"] = hlsl::stage_name(record.stage);
  json["keywords"] = record.keywords;
  json["results"] = Json::array();
  return json;
}

Json result_json(const VariantRecord& record, Lines& messages) {
  Json json{{"target", record.target}, {"status", status_name(record.status)}, {"messages", Json::array()}};
  for (const hlsl::Diagnostic& said : record.diagnostics)
    json["messages"].push_back(messages.add(line_of(message_json(said))));
  if (!record.reason.empty()) json["reason"] = record.reason;
  if (record.cached) json["cached"] = true;
  if (!record.reproduction.empty()) json["reproduction"] = record.reproduction;
  if (!record.module.empty()) json["module"] = record.module;
  if (record.place != 0) json["place"] = record.place;
  return json;
}

class Document {
 public:
  // Adds a key with its value, whose lines are indented.
  void add(const std::string& key, const Json& value) {
    std::string text = value.dump(2, ' ', true, Json::error_handler_t::replace);
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
      text.insert(at + 1, "  ");
    put(key, text);
  }
  void add_lines(const std::string& key, const std::vector<std::string>& lines) {
    put(key, lines.empty() ? "[]" : "[\n    " + joined(lines, ",\n    ") + "\n  ]");
  }
  std::string take() { return "{\n" + text_ + "\n}\n"; }

 private:
  void put(const std::string& key, const std::string& value) {
    text_ += (text_.empty() ? "  \"" : ",\n  \"") + key + "\": " + value;
  }
  std::string text_;
};

}  // namespace

std::string report_json(const ValidationReport& report) {
  const Variants variants(report);
  const Totals totals = totals_of(report, variants);
  Document json;
  json.add("summary", {{"variants", totals.variants},
                       {"results", totals.results},
                       {"unique", report.unique},
                       {"failed", report.count(VariantStatus::failed)},
                       {"cached", totals.cached},
                       {"seconds", report.seconds},
                       {"absent", report.count(VariantStatus::absent)},
                       {"unreached", report.count(VariantStatus::unreached)},
                       {"unchecked", report.count(VariantStatus::unchecked)}});
  if (const FrontEnds counts = front_ends(report); counts.compared != 0)
    json.add("front_ends", {{"compared", counts.compared},
                            {"both_refuse", counts.both},
                            {"fxc_alone_refuses", counts.fxc_alone},
                            {"glslang_alone_refuses", counts.glslang_alone}});
  json.add("shard", {{"index", report.shard}, {"count", report.shards}});
  json.add("fingerprint", report.fingerprint);
  json.add("checks", report.checks);
  json.add("rules", report.rules);
  json.add("packages", report.packages);
  Json minimal = Json::array();
  for (const MinimalKeywords& one : report.minimal)
    minimal.push_back({{"error", message_json(one.error)}, {"keywords", one.keywords}});
  if (!minimal.empty()) json.add("minimal_keywords", minimal);

  Lines messages;
  std::vector<Json> of_variant(variants.size());
  for (std::size_t i = 0; i < report.records.size(); ++i) {
    Json& variant = of_variant[variants.of_record(i)];
    if (variant.is_null()) variant = variant_json(report.records[i]);
    variant["results"].push_back(result_json(report.records[i], messages));
  }
  std::vector<std::string> compiled;
  std::vector<std::string> sources;
  for (const Json& variant : of_variant)
    (variant["results"][0]["target"] == whole_source ? sources : compiled).push_back(line_of(variant));
  json.add_lines("messages", messages.all());
  json.add_lines("sources", sources);
  json.add_lines("variants", compiled);
  return json.take();
}

}  // namespace penumbra::validation
