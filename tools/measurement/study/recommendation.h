// Whom its manifest recommends a technique to, by the figures that were measured.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/results.h"
#include "study/summary.h"
#include "techniques/technique_list.h"

namespace penumbra::study {

struct Recommendation {
  std::string use_when;  // one line each, may be empty
  std::string not_when;
};

using Recommendations = std::map<std::string, Recommendation>;  // by technique; those that have a line

// The lines are the manifests' as they are now, not as they were when the figures were measured: they are
// written after the figures.
Recommendations recommendations(const techniques::TechniqueList& list);

struct RecommendedChoice {
  Choice choice;
  Recommendation lines;
};

// Those of the techniques that were measured, each once, in record order.
std::vector<RecommendedChoice> recommended(const Results& results, const Recommendations& recommendations);

}  // namespace penumbra::study
