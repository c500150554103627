#include <algorithm>

#include "hlsl/stage.h"
#include "input/located_json.h"
#include "input/nearest_name.h"
#include "validation/report.h"
#include "validation/report_findings.h"
#include "validation/report_merge.h"

namespace penumbra::validation {

namespace {

std::size_t whole_number(JsonObject& object, const std::string& key) {
  const int number = object.integer(key, 0);
  if (number < 0) object.fail(key, "'" + key + "' must not be negative");
  return static_cast<std::size_t>(number);
}

std::string required_text(JsonObject& object, const std::string& key) {
  if (!object.has(key))
    object.fail(key, "there is no '" + key + "'", "is this a report of penumbra validate?");
  return object.text(key, {});
}

hlsl::Severity read_severity(JsonObject& object) {
  const std::string name = required_text(object, "severity");
  if (name == "error") return hlsl::Severity::error;
  if (name == "warning") return hlsl::Severity::warning;
  if (name != "note") object.fail("severity", "'" + name + "' is not a severity", "error, warning or note");
  return hlsl::Severity::note;
}

hlsl::Diagnostic read_diagnostic(JsonObject object) {
  hlsl::Diagnostic diagnostic;
  diagnostic.file = object.text("file", {});
  diagnostic.line = static_cast<int>(whole_number(object, "line"));
  diagnostic.column = static_cast<int>(whole_number(object, "column"));
  diagnostic.severity = read_severity(object);
  diagnostic.message = required_text(object, "message");
  diagnostic.source_line = object.text("source_line", {});
  diagnostic.rule = object.text("rule", {});
  object.finish();
  return diagnostic;
}

hlsl::Stage read_stage(JsonObject& object) {
  const std::string name = required_text(object, "stage");
  const std::optional<hlsl::Stage> stage = hlsl::find_stage(name);
  if (!stage) object.fail("stage", "unknown stage '" + name + "'");
  return *stage;
}

VariantStatus read_status(JsonObject& object) {
  const std::string name = required_text(object, "status");
  const std::optional<VariantStatus> status = find_status(name);
  if (!status) object.fail("status", "unknown status '" + name + "'");
  return *status;
}

// Adds the records of a variant, or of a file or program as a whole.
void read_variant(JsonObject object, const std::vector<hlsl::Diagnostic>& messages,
                  std::vector<VariantRecord>& records) {
  VariantRecord variant;
  variant.technique = object.text("technique", {});
  variant.file = required_text(object, "file");
  variant.shader = object.text("shader", {});
  variant.pass = object.text("pass", {});
  variant.entry = required_text(object, "entry");
  variant.stage = read_stage(object);
  variant.keywords = object.texts("keywords");
  for (JsonObject& result : object.objects("results")) {
    VariantRecord& record = records.emplace_back(variant);
    record.target = required_text(result, "target");
    record.status = read_status(result);
    for (const std::size_t message : result.indices("messages", messages.size()))
      record.diagnostics.push_back(messages[message]);
    record.reason = result.text("reason", {});
    record.cached = result.boolean("cached", false);
    record.reproduction = result.text("reproduction", {});
    record.module = result.text("module", {});
    record.place = whole_number(result, "place");
    result.finish();
  }
  object.finish();
}

std::map<std::string, std::string> read_texts(JsonObject object) {
  std::map<std::string, std::string> texts;
  for (const std::string& key : object.keys()) texts[key] = object.text(key, {});
  return texts;
}

void check_count(JsonObject& summary, const std::string& key, std::size_t counted) {
  if (whole_number(summary, key) != counted)
    summary.fail(key, "the summary's '" + key + "' is not what the results count: " + std::to_string(counted),
                 "the file was changed or truncated; create it again");
}

void read_summary(JsonObject summary, ValidationReport& report) {
  const Totals totals = totals_of(report, Variants(report));
  check_count(summary, "variants", totals.variants);
  check_count(summary, "results", totals.results);
  check_count(summary, "failed", report.count(VariantStatus::failed));
  check_count(summary, "cached", totals.cached);
  check_count(summary, "absent", report.count(VariantStatus::absent));
  check_count(summary, "unreached", report.count(VariantStatus::unreached));
  check_count(summary, "unchecked", report.count(VariantStatus::unchecked));
  report.unique = whole_number(summary, "unique");
  report.seconds = summary.number("seconds", 0.0);
  summary.finish();
}

void read_front_ends(JsonObject counts, const ValidationReport& report) {
  const FrontEnds of_records = front_ends(report);
  check_count(counts, "compared", of_records.compared);
  check_count(counts, "both_refuse", of_records.both);
  check_count(counts, "fxc_alone_refuses", of_records.fxc_alone);
  check_count(counts, "glslang_alone_refuses", of_records.glslang_alone);
  counts.finish();
}

void read_shard(JsonObject shard, ValidationReport& report) {
  const int index = shard.integer("index", 1);
  const int count = shard.integer("count", 1);
  if (index < 1 || index > count) shard.fail("index", "the shard must be from 1 to their count");
  report.shard = static_cast<unsigned>(index);
  report.shards = static_cast<unsigned>(count);
  shard.finish();
}

}  // namespace

ValidationReport read_report_json(const std::filesystem::path& file) {
  const LocatedJson document = LocatedJson::read(file);
  JsonObject object(document);
  if (!object.has("variants"))
    object.fail("variants", "this is not a report of penumbra validate",
                "make one with: penumbra validate --format json -o FILE");
  ValidationReport report;
  std::vector<hlsl::Diagnostic> messages;
  for (const JsonObject& message : object.objects("messages")) messages.push_back(read_diagnostic(message));
  for (const char* kind : {"sources", "variants"})
    for (const JsonObject& variant : object.objects(kind)) read_variant(variant, messages, report.records);
  std::stable_sort(report.records.begin(), report.records.end(),
                   [](const VariantRecord& a, const VariantRecord& b) { return a.place < b.place; });
  read_summary(object.object("summary"), report);
  if (object.has("front_ends")) read_front_ends(object.object("front_ends"), report);
  read_shard(object.object("shard"), report);
  report.fingerprint = object.text("fingerprint", {});
  report.checks = read_texts(object.object("checks"));
  report.rules = read_texts(object.object("rules"));
  report.packages = object.texts("packages");
  for (JsonObject& minimal : object.objects("minimal_keywords")) {
    report.minimal.push_back({read_diagnostic(minimal.object("error")), minimal.texts("keywords")});
    minimal.finish();
  }
  object.finish();
  return report;
}

}  // namespace penumbra::validation
