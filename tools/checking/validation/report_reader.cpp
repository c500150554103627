#include "hlsl/stage.h"
#include "input/located_json.h"
#include "input/nearest_name.h"
#include "validation/report.h"
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

VariantRecord read_record(JsonObject object) {
  VariantRecord record;
  record.technique = object.text("technique", {});
  record.file = required_text(object, "file");
  record.shader = object.text("shader", {});
  record.pass = object.text("pass", {});
  record.entry = required_text(object, "entry");
  record.stage = read_stage(object);
  record.keywords = object.texts("keywords");
  record.target = required_text(object, "target");
  record.status = read_status(object);
  for (const JsonObject& diagnostic : object.objects("diagnostics"))
    record.diagnostics.push_back(read_diagnostic(diagnostic));
  record.reason = object.text("reason", {});
  record.cached = object.boolean("cached", false);
  record.reproduction = object.text("reproduction", {});
  record.module = object.text("module", {});
  record.place = whole_number(object, "place");
  object.finish();
  return record;
}

std::map<std::string, std::string> read_texts(JsonObject object) {
  std::map<std::string, std::string> texts;
  for (const std::string& key : object.keys()) texts[key] = object.text(key, {});
  return texts;
}

void check_count(JsonObject& summary, const std::string& key, std::size_t counted) {
  if (whole_number(summary, key) != counted)
    summary.fail(key, "the summary's '" + key + "' is not what the records count: " + std::to_string(counted),
                 "the file was changed or truncated; create it again");
}

void read_summary(JsonObject summary, ValidationReport& report) {
  std::size_t cached = 0;
  for (const VariantRecord& record : report.records) cached += record.cached ? 1 : 0;
  check_count(summary, "variants", report.records.size());
  check_count(summary, "failed", report.count(VariantStatus::failed));
  check_count(summary, "cached", cached);
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
  for (const JsonObject& record : object.objects("variants")) report.records.push_back(read_record(record));
  read_summary(object.object("summary"), report);
  if (object.has("front_ends")) read_front_ends(object.object("front_ends"), report);
  read_shard(object.object("shard"), report);
  report.fingerprint = object.text("fingerprint", {});
  report.checks = read_texts(object.object("checks"));
  report.rules = read_texts(object.object("rules"));
  for (JsonObject& minimal : object.objects("minimal_keywords")) {
    report.minimal.push_back({read_diagnostic(minimal.object("error")), minimal.texts("keywords")});
    minimal.finish();
  }
  object.finish();
  return report;
}

}  // namespace penumbra::validation
