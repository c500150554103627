#include "validation/minimal_keywords.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "validation/report_findings.h"

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

}  // namespace

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

}  // namespace penumbra::validation
