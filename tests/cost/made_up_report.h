// A report of figures made up for the tests of its forms.
#pragma once

#include <string>
#include <vector>

#include "cost/cost_report.h"

namespace penumbra::cost::made_up {

inline CostRow row(const std::string& family, std::vector<CostVariant> variants, std::uint64_t instructions) {
  CostRow made;
  made.family = family;
  made.file = "ShaderLibrary/Filters/MadeUp.hlsl";
  made.entry = "Fragment";
  made.stage = "fragment";
  made.variants = std::move(variants);
  made.measured.subgroup_size = 64;
  made.measured.statistics = {{"Driver pipeline hash", 12345},
                              {"Instructions", instructions},
                              {"VGPRs", 24},
                              {"SGPRs", 0},
                              {"Spilled VGPRs", 0},
                              {"Subgroups per SIMD", 16},
                              {"Code size", 8 * instructions},
                              {"Branches", 3}};
  made.measured.figures = figures_of(made.measured.statistics);
  return made;
}

inline CostReport report() {
  CostReport made;
  made.command = "penumbra cost --family old --family new";
  made.driver = "radv Mesa 1.2.3";
  made.compiler = "glslang 1, SPIRV-Tools 2";
  made.families = {{"old", "Old GPU", made.driver}, {"new", "New GPU", made.driver}};
  for (const char* family : {"old", "new"}) {
    made.rows.push_back(row(family, {{"hard", {}}}, 90));
    made.rows.push_back(row(family, {{"hard", {"REVERSED"}}}, 91));
    made.rows.push_back(row(family, {{"box-3", {}}, {"box-5", {}}}, 140));
  }
  return made;
}

}  // namespace penumbra::cost::made_up
