#include "cli/static_cycles.h"

#include <algorithm>
#include <map>
#include <utility>

namespace penumbra::cli {
namespace {

// The filter's entry, which `cost` measures in a pass of its own.
constexpr const char* kFilterEntry = "Fragment";

bool has(const std::vector<std::string>& keywords, const char* keyword) {
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

// Rates how well the row represents what a desktop runs of the technique; 0 means not at all.
int fitness(const cost::CostRow& row, const std::string& technique) {
  int best = 0;
  for (const cost::CostVariant& variant : row.variants) {
    if (variant.technique != technique || has(variant.keywords, "PENUMBRA_UNLIMITED") ||
        has(variant.keywords, "_ALPHATEST_ON"))
      continue;
    best = std::max(best, has(variant.keywords, "UNITY_REVERSED_Z") ? 2 : 1);
  }
  return best;
}

// Returns the program that gives the visibility: that of the pass that writes it, or the filter.
std::string visibility_entry(const techniques::Technique& technique) {
  for (const techniques::GraphPass& pass : technique.graph.passes)
    if (!technique.graph.visibility.empty() && techniques::writes_to(pass, technique.graph.visibility))
      return pass.program;
  return kFilterEntry;
}

std::optional<study::ProgramCycles> cycles_of(const techniques::Technique& technique,
                                              const cost::CostReport& report, const std::string& family) {
  std::map<std::string, std::pair<int, double>> by_entry;  // fitness and cycles
  for (const cost::CostRow& row : report.rows) {
    if (row.family != family || row.stage == "vertex" || !row.measured.figures.inverse_throughput_cycles)
      continue;
    const int fit = fitness(row, technique.name);
    auto& best = by_entry[row.entry];
    if (fit > best.first) best = {fit, static_cast<double>(*row.measured.figures.inverse_throughput_cycles)};
  }
  const std::string entry = visibility_entry(technique);
  if (by_entry[entry].first == 0) return std::nullopt;
  study::ProgramCycles cycles;
  for (const auto& [name, best] : by_entry)
    (name == entry ? cycles.visibility : cycles.others) += best.second;
  return cycles;
}

}  // namespace

void add_cycles(study::FactsOfTechniques& facts, const techniques::TechniqueList& list,
                const cost::CostReport& report) {
  if (report.families.empty()) return;
  std::string family = report.families.front().name;
  for (const cost::RadvFamily& each : report.families)
    if (each.name == "navi21") family = each.name;
  const std::string earlier = std::exchange(facts.cycles_of, "RADV, " + family);
  if (earlier != facts.cycles_of)
    for (auto& [name, of_technique] : facts.techniques) of_technique.cycles.reset();
  for (const techniques::Technique& technique : list.techniques)
    if (const auto cycles = cycles_of(technique, report, family))
      facts.techniques[technique.name].cycles = cycles;
}

}  // namespace penumbra::cli
