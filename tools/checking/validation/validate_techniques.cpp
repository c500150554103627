#include "validation/validate_techniques.h"

#include <chrono>
#include <set>
#include <utility>

#include "platform/content_hash.h"
#include "validation/minimal_keywords.h"
#include "validation/source_variants.h"
#include "validation/stage_linkage.h"
#include "validation/target_check.h"
#include "validation/unit_lint.h"

namespace penumbra::validation {

namespace {

// A target that a technique's manifest lists as absent is still tried, so that an outdated entry is reported.
void judge(VariantRecord& record, const techniques::Technique* technique) {
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
                                  "works, although its manifest lists it as absent: " + absent->second,
                                  {}});
  }
}

// A target that lacks a feature required by the technique's graph fails, although the program compiles.
void add_target_problems(VariantRecord& record, const techniques::Technique* technique) {
  if (technique == nullptr || record.status == VariantStatus::unreached) return;
  for (const techniques::GraphPass& pass : technique->graph.passes) {
    const bool its = pass.program == record.pass && record.file.ends_with(pass.file);
    if (!its || record.stage != hlsl::Stage::compute) continue;
    for (hlsl::Diagnostic& problem : techniques::target_problems(technique->graph, pass, record.target)) {
      record.status = VariantStatus::failed;
      record.diagnostics.push_back(std::move(problem));
    }
  }
}

void add_records(const SourceVariant& variant, const UnitResult& result, std::size_t report_place,
                 ValidationReport& report) {
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
    record.module = result.module_key;
    record.place = report_place;
    if (!result.missing_editor_include.empty())
      record.reason = "'" + result.missing_editor_include +
                      "' ships only with the Unity editor; name its CGIncludes folder with --cginc-root DIR";
    if (record.status == VariantStatus::passed && record.diagnostics.empty()) {
      record.reason = why_absent(record.stage, record.target);
      if (!record.reason.empty()) record.status = VariantStatus::absent;
    }
    add_target_problems(record, variant.technique);
    judge(record, variant.technique);
    report.records.push_back(std::move(record));
  }
}

// Hashes the request without the shard, so that the hash is equal for all shards of one run.
std::string fingerprint_of(const ValidationRequest& request, const std::vector<CompileUnit>& units) {
  platform::ContentHash hash;
  for (const CompileUnit& unit : units) hash.update(encode(unit));
  for (const VariantRecord& record : request.records) hash.update(record.file).update(record.pass);
  return hash.update(std::uint64_t{request.engine.shard.count}).hex();
}

}  // namespace

ValidationReport validate(const ValidationRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  ValidationReport report;
  for (const std::string& target : request.targets) report.checks[target] = checked_by(target);
  // Diagnostics from before compilation belong to the first shard.
  if (request.engine.shard.index == 1) report.records = request.records;
  for (std::size_t i = 0; i < report.records.size(); ++i) report.records[i].place = i;
  std::vector<SourceVariant> variants = source_variants(request);
  for (const CompileUnit& unit : request.units) variants.push_back({nullptr, unit});
  std::vector<CompileUnit> units;
  units.reserve(variants.size());
  for (const SourceVariant& variant : variants) units.push_back(variant.unit);
  leave_to_compilers(units);
  EngineRun run = run_units(units, request.engine);
  link_stages(units, request.engine, run.results);
  report.shard = request.engine.shard.index;
  report.shards = request.engine.shard.count;
  report.fingerprint = fingerprint_of(request, units);
  std::set<std::pair<std::string, std::string>> unique;
  for (const UnitResult& result : run.results) {
    add_records(variants[result.unit], result, request.records.size() + result.unit, report);
    if (result.module_key.empty()) continue;
    for (const std::string& target : units[result.unit].targets) unique.emplace(result.module_key, target);
  }
  report.unique = unique.size();
  if (request.lint.wanted) {
    for (const lint::RuleInfo& rule : lint::rules()) report.rules[rule.name] = rule.summary;
    // A single shard has only a part of the variants.
    if (report.shards == 1)
      for (VariantRecord& record : program_findings(request.programs, units, run.results, request.lint)) {
        record.place = request.records.size() + units.size() + report.records.size();
        report.records.push_back(std::move(record));
      }
  }
  if (request.minimise)
    report.minimal = minimal_keywords(report, units, request.records.size(), request.engine);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace penumbra::validation
