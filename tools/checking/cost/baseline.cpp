#include "cost/baseline.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "cost/families.h"
#include "input/baseline_text.h"
#include "input/counted.h"
#include "input/input_error.h"
#include "input/visible_text.h"

namespace penumbra::cost {
namespace {

using Names =
    std::tuple<std::string, std::string, std::string, std::string, std::string, std::vector<std::string>>;
// Variants of equal names, as those of two passes with one name, are numbered in the report's order.
using Key = std::pair<Names, int>;

struct KeyedVariant {
  Key key;
  const CostRow* row = nullptr;
  const CostVariant* variant = nullptr;
};

std::vector<KeyedVariant> keyed_variants(const CostReport& report) {
  std::vector<KeyedVariant> all;
  std::map<Names, int> met;
  for (const CostRow& row : report.rows)
    for (const CostVariant& variant : row.variants) {
      Names names{row.family, row.file, row.entry, row.stage, variant.technique, variant.keywords};
      const int number = met[names]++;
      all.push_back({{std::move(names), number}, &row, &variant});
    }
  return all;
}

std::map<Key, const CostRow*> rows_by_key(const std::vector<KeyedVariant>& variants) {
  std::map<Key, const CostRow*> rows;
  for (const KeyedVariant& keyed : variants) rows.emplace(keyed.key, keyed.row);
  return rows;
}

bool within(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

// A row of a .shader names its pass after the file.
bool within_files(const std::vector<std::string>& files, const std::string& name) {
  return std::any_of(files.begin(), files.end(),
                     [&](const std::string& file) { return name == file || name.starts_with(file + ": "); });
}

bool expected(const CostRow& row, const CostVariant& variant, const ComparedExtent& extent) {
  if (!within(extent.families, row.family)) return false;
  if (variant.technique.empty()) return within_files(extent.files, row.file);
  return (extent.files.empty() || !extent.techniques.empty()) && within(extent.techniques, variant.technique);
}

std::string named(const CostRow& row, const CostVariant& variant) {
  CostRow alone = row;
  alone.variants = {variant};
  return row.family + " " + row_name(alone);
}

void compare_rows(const CostRow& now, const CostRow& before, const std::string& name,
                  double tolerance_percent, BaselineComparison& comparison) {
  ++comparison.compared;
  for (const FigureName& figure : figure_names()) {
    const Figure& was = before.measured.figures.*figure.value;
    const Figure& is = now.measured.figures.*figure.value;
    if (!was || !is || *was == *is) continue;
    const double sign = figure.more_is_better ? -1.0 : 1.0;
    const double growth = sign * (static_cast<double>(*is) - static_cast<double>(*was));
    const bool beyond = growth > static_cast<double>(*was) * tolerance_percent / 100.0;
    if (growth < 0) comparison.better.push_back({name, figure.heading, *was, *is});
    if (growth > 0 && beyond) comparison.worse.push_back({name, figure.heading, *was, *is});
  }
}

std::string change_text(const char* kind, const BaselineChange& change) {
  return std::string(kind) + ": " + visible(change.row) + ": " + change.figure + " " +
         std::to_string(change.before) + " -> " + std::to_string(change.after) + "\n";
}

bool has_radv(const CostReport& report) {
  return report.families.empty() ||
         std::any_of(report.families.begin(), report.families.end(),
                     [](const RadvFamily& family) { return family.name != direct3d_family.name; });
}

bool has_bytecode(const CostReport& report) {
  return std::any_of(report.families.begin(), report.families.end(),
                     [](const RadvFamily& family) { return family.name == direct3d_family.name; });
}

}  // namespace

// Returns the compilers of the families that both have; without any, of all.
std::string compilers_of(const CostReport& report, const CostReport& other) {
  std::string names;
  if (has_radv(report) && has_radv(other)) names = report.driver + " and " + report.compiler;
  if (has_bytecode(report) && has_bytecode(other))
    names += (names.empty() ? "" : " and ") + driver_of(report, direct3d_family.name);
  if (!names.empty()) return names;
  return has_radv(report) ? report.driver + " and " + report.compiler : report.driver;
}

BaselineComparison compare_with_baseline(const CostReport& report, const CostReport& baseline,
                                         const ComparedExtent& extent, double tolerance_percent) {
  BaselineComparison comparison;
  const std::vector<KeyedVariant> variants_before = keyed_variants(baseline);
  const std::vector<KeyedVariant> variants_now = keyed_variants(report);
  const std::map<Key, const CostRow*> before = rows_by_key(variants_before);
  const std::map<Key, const CostRow*> now = rows_by_key(variants_now);
  // Variants of one module were also in one module before, so such a pair of rows is reported once.
  std::set<std::pair<const CostRow*, const CostRow*>> met;
  for (const auto& [key, row, variant] : variants_now) {
    if (!within(extent.families, row->family)) continue;
    const auto found = before.find(key);
    if (found == before.end()) {
      comparison.unknown.push_back(named(*row, *variant));
    } else if (met.emplace(row, found->second).second && row->measured.failure.empty()) {
      compare_rows(*row, *found->second, row->family + " " + row_name(*row), tolerance_percent, comparison);
    }
  }
  for (const auto& [key, row, variant] : variants_before)
    if (expected(*row, *variant, extent) && !now.contains(key))
      comparison.gone.push_back(named(*row, *variant));
  return comparison;
}

void require_same_compilers(const CostReport& ours, const CostReport& baseline, const std::string& file) {
  const std::string before = compilers_of(baseline, ours);
  const std::string now = compilers_of(ours, baseline);
  if (before == now) return;
  throw EnvironmentError(
      file + ": measured with " + before + ", but this machine has " + now +
      "\n  install those versions, or write a new baseline on this machine with --format json -o " + file +
      ", or compare anyway with --any-driver");
}

std::string comparison_text(const BaselineComparison& comparison) {
  std::string text;
  for (const BaselineChange& change : comparison.worse) text += change_text("worse", change);
  for (const BaselineChange& change : comparison.better) text += change_text("better", change);
  return text + baseline_lines(comparison.unknown, comparison.gone) + counted(comparison.compared, "row") +
         " compared, " + counted(comparison.worse.size(), "figure") + " worse, " +
         std::to_string(comparison.better.size()) + " better, " +
         baseline_counts("row", comparison.unknown.size(), comparison.gone.size()) + "\n";
}

}  // namespace penumbra::cost
