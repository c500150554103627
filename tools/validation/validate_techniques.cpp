#include "validation/validate_techniques.h"

#include <chrono>
#include <set>
#include <utility>

#include "validation/source_variants.h"
#include "validation/target_check.h"

namespace penumbra::validation {

namespace {

// A target that techniques.json gives up on is tried all the same, so that the entry goes when it can.
void judge(VariantRecord& record, const shaders::Technique* technique) {
  if (technique == nullptr) return;
  const auto absent = technique->targets_absent.find(record.target);
  if (absent == technique->targets_absent.end() || record.status == VariantStatus::unreached) return;
  record.reason = absent->second;
  if (record.status == VariantStatus::failed) {
    record.status = VariantStatus::absent;
  } else {
    record.diagnostics.push_back({record.file,
                                  0,
                                  0,
                                  hlsl::Severity::note,
                                  "works, although techniques.json lists it as absent: " + absent->second,
                                  {}});
  }
}

void add_records(const SourceVariant& variant, const UnitResult& result, ValidationReport& report) {
  const CompileUnit& unit = variant.unit;
  for (std::size_t i = 0; i < unit.targets.size(); ++i) {
    VariantRecord record;
    record.technique = unit.technique;
    record.file = unit.file;
    record.shader = unit.shader;
    record.pass = unit.pass;
    record.entry = unit.compile.entry;
    record.stage = unit.compile.stage;
    record.keywords = unit.keywords;
    record.target = unit.targets[i];
    record.status = result.targets[i].status;
    record.diagnostics = result.targets[i].diagnostics;
    record.reproduction = result.targets[i].reproduction;
    record.cached = result.cached;
    if (!result.missing_editor_include.empty())
      record.reason = "'" + result.missing_editor_include + "' ships with the Unity editor alone";
    judge(record, variant.technique);
    report.records.push_back(std::move(record));
  }
}

}  // namespace

ValidationReport validate(const ValidationRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  ValidationReport report;
  for (const std::string& target : request.targets) report.checks[target] = checked_by(target);
  if (request.engine.shard.index == 1) report.records = request.records;
  std::vector<SourceVariant> variants = source_variants(request);
  for (const CompileUnit& unit : request.units) variants.push_back({nullptr, unit});
  std::vector<CompileUnit> units;
  units.reserve(variants.size());
  for (const SourceVariant& variant : variants) units.push_back(variant.unit);
  const EngineRun run = run_units(units, request.engine);
  std::set<std::pair<std::string, std::string>> unique;
  for (const UnitResult& result : run.results) {
    add_records(variants[result.unit], result, report);
    if (result.module_key.empty()) continue;
    for (const std::string& target : units[result.unit].targets) unique.emplace(result.module_key, target);
  }
  report.unique = unique.size();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace penumbra::validation
