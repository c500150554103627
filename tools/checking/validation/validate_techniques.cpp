#include "validation/validate_techniques.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <utility>

#include "lint/rule.h"
#include "platform/content_hash.h"
#include "validation/report_findings.h"
#include "validation/source_variants.h"
#include "validation/stage_linkage.h"
#include "validation/target_check.h"
#include "validation/unit.h"

namespace penumbra::validation {
namespace {

bool is_one_of(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

CompileUnit with_keywords(const CompileUnit& unit, const std::vector<std::string>& keywords) {
  CompileUnit fewer = unit;
  fewer.keywords = keywords;
  std::erase_if(fewer.compile.defines, [&](const auto& define) {
    return is_one_of(define.first, unit.keywords) && !is_one_of(define.first, keywords);
  });
  return fewer;
}

bool is_same_message(const hlsl::Diagnostic& a, const hlsl::Diagnostic& b) {
  return a.severity == b.severity && a.file == b.file && a.line == b.line && a.column == b.column &&
         a.message == b.message;
}

// The smallest variant that has the error, and the diagnostic.
struct Failure {
  const CompileUnit* unit = nullptr;
  std::size_t target = 0;
  hlsl::Diagnostic said;
};

class Reduction {
 public:
  Reduction(const Failure& failure, const EngineOptions& engine) : failure_(failure), engine_(engine) {
    engine_.shard = {};
    engine_.progress = nullptr;
    engine_.emitted = nullptr;
    engine_.cache.clear();  // these variants were not requested
  }

  // Returns nothing for an error that the unit does not have on its own: one between two stages.
  std::optional<std::vector<std::string>> reduce() {
    std::vector<std::string> needed = failure_.unit->keywords;
    if (!fail({needed})[0]) return std::nullopt;
    if (fail({{}})[0]) return std::vector<std::string>{};
    while (needed.size() > 1) {
      std::vector<std::vector<std::string>> fewer;
      for (std::size_t i = 0; i < needed.size(); ++i) fewer.push_back(without(needed, i));
      const std::vector<bool> failing = fail(fewer);
      std::vector<std::string> kept;
      for (std::size_t i = 0; i < needed.size(); ++i)
        if (!failing[i]) kept.push_back(needed[i]);
      if (kept.size() == needed.size()) break;
      // The kept keywords usually suffice, as rarely two removable keywords are interchangeable.
      needed = !kept.empty() && fail({kept})[0]
                   ? kept
                   : fewer[static_cast<std::size_t>(std::find(failing.begin(), failing.end(), true) -
                                                    failing.begin())];
    }
    return needed;
  }

 private:
  static std::vector<std::string> without(std::vector<std::string> keywords, std::size_t index) {
    keywords.erase(keywords.begin() + static_cast<std::ptrdiff_t>(index));
    return keywords;
  }

  // Returns for each of the keyword sets whether the error occurs with it.
  std::vector<bool> fail(const std::vector<std::vector<std::string>>& sets) const {
    std::vector<CompileUnit> units;
    units.reserve(sets.size());
    for (const std::vector<std::string>& keywords : sets)
      units.push_back(with_keywords(*failure_.unit, keywords));
    std::vector<bool> failing;
    for (const UnitResult& result : run_units(units, engine_).results) {
      const std::vector<hlsl::Diagnostic>& said = result.targets[failure_.target].diagnostics;
      failing.push_back(std::any_of(said.begin(), said.end(), [this](const hlsl::Diagnostic& diagnostic) {
        return is_same_message(diagnostic, failure_.said);
      }));
    }
    return failing;
  }

  const Failure& failure_;
  EngineOptions engine_;
};

Failure smallest_failure(const Finding& finding, const ValidationReport& report,
                         const std::vector<CompileUnit>& units, std::size_t first_place) {
  Failure failure;
  for (const std::size_t index : finding.records) {
    const VariantRecord& record = report.records[index];
    if (record.target == whole_source || record.place < first_place) continue;
    const CompileUnit& unit = units.at(record.place - first_place);
    if (failure.unit != nullptr && failure.unit->keywords.size() <= unit.keywords.size()) continue;
    const auto said = std::find_if(record.diagnostics.begin(), record.diagnostics.end(),
                                   [&](const hlsl::Diagnostic& diagnostic) {
                                     return is_same_message(as_told(diagnostic, record), finding.diagnostic);
                                   });
    const auto target = std::find(unit.targets.begin(), unit.targets.end(), record.target);
    if (said == record.diagnostics.end() || target == unit.targets.end()) continue;
    failure = {&unit, static_cast<std::size_t>(target - unit.targets.begin()), *said};
  }
  return failure;
}

// Minimises the keywords of failing variants.
//
// For each error, the variant with the fewest keywords that has it is compiled again with keywords removed,
// until removing any other one loses the error: same file, line, column, message and target. The candidates
// need not be variants that Unity would build. A variant with n keywords costs between 2 and about n * n / 2
// compilations.

// units[i] is the unit of the records with place first_place + i. The result has one entry for each error of
// a variant with keywords, in the order of the records.
std::vector<MinimalKeywords> minimal_keywords(const ValidationReport& report,
                                              const std::vector<CompileUnit>& units, std::size_t first_place,
                                              const EngineOptions& engine) {
  std::vector<MinimalKeywords> list;
  for (const Finding& finding : findings(report)) {
    if (finding.diagnostic.severity != hlsl::Severity::error) continue;
    const Failure failure = smallest_failure(finding, report, units, first_place);
    if (failure.unit == nullptr || failure.unit->keywords.empty()) continue;
    if (std::optional<std::vector<std::string>> needed = Reduction(failure, engine).reduce())
      list.push_back({finding.diagnostic, *std::move(needed)});
  }
  return list;
}

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
    record.reason = result.unchecked;
    if (record.status == VariantStatus::unchecked && record.reason.empty() && !record.diagnostics.empty())
      record.reason = record.diagnostics.back().message;
    if (record.status == VariantStatus::passed || record.status == VariantStatus::unchecked) {
      const std::string absent = why_absent(record.stage, record.target);
      if (!absent.empty()) {
        record.status = VariantStatus::absent;
        record.reason = absent;
      }
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
  EngineRun run = run_units(units, request.engine);
  link_stages(units, request.engine, run.results);
  report.shard = request.engine.shard.index;
  report.shards = request.engine.shard.count;
  report.fingerprint = fingerprint_of(request, units);
  report.packages = request.packages;
  std::set<std::pair<std::string, std::string>> unique;
  for (const UnitResult& result : run.results) {
    add_records(variants[result.unit], result, request.records.size() + result.unit, report);
    if (result.module_key.empty()) continue;
    for (const std::string& target : units[result.unit].targets) unique.emplace(result.module_key, target);
  }
  report.unique = unique.size();
  if (std::any_of(report.records.begin(), report.records.end(),
                  [](const VariantRecord& record) { return is_from_bytecode(record.diagnostics); }))
    report.rules[from_bytecode] =
        "Tells that FXC accepts a program that glslang refuses, and that its bytecode was checked.";
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
