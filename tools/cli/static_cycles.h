// The cycles that a compiler estimates, from a report of `penumbra cost`, for the tables of `measure`.
#pragma once

#include "cost/cost_report.h"
#include "study/technique_facts.h"
#include "techniques/technique_list.h"

namespace penumbra::cli {

// The cycles are those of one GPU family of the report, navi21 if it has that. A technique without rows keeps
// what an earlier report gave it, if that was of the same family.
void add_cycles(study::FactsOfTechniques& facts, const techniques::TechniqueList& list,
                const cost::CostReport& report);

}  // namespace penumbra::cli
