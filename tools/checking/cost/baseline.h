// Compares this run's figures with those of a committed report.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cost/cost_report.h"

namespace penumbra::cost {

struct BaselineChange {
  std::string row;     // family and row_name() of this run's row
  std::string figure;  // FigureName::heading
  std::uint64_t before = 0;
  std::uint64_t after = 0;
};

struct BaselineComparison {
  std::vector<BaselineChange> worse;  // beyond the tolerance
  std::vector<BaselineChange> better;
  std::vector<std::string> unknown;  // rows of this run that the baseline lacks
  std::vector<std::string> gone;     // rows of the baseline that this run should have produced
  std::size_t compared = 0;          // rows

  bool passed() const { return worse.empty() && unknown.empty() && gone.empty(); }
};

// The extent of the run: a baseline may contain more. Empty lists mean everything; rows of other families
// than these are not compared.
struct ComparedExtent {
  std::vector<std::string> families;
  std::vector<std::string> techniques;
  std::vector<std::string> files;  // a user's own files; without techniques, only their rows are expected
};

// A figure is worse when it is larger (occupancy: smaller) than before by more than tolerance_percent; rows
// are matched by family, file, entry, stage, technique and keywords, so techniques whose modules become
// identical, or no longer are, are still compared with their own earlier figures.
BaselineComparison compare_with_baseline(const CostReport& report, const CostReport& baseline,
                                         const ComparedExtent& extent, double tolerance_percent);

// Throws EnvironmentError if the driver or the SPIR-V compiler differs: figures of different compilers are
// not comparable. `file` names the baseline.
void require_same_compilers(const CostReport& ours, const CostReport& baseline, const std::string& file);
// Returns "radv Mesa 22.3.6 and glslang 12", and FXC where both reports have its bytecode.
std::string compilers_of(const CostReport& report, const CostReport& other);

std::string comparison_text(const BaselineComparison& comparison);

}  // namespace penumbra::cost
