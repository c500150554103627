#include "study/recommendation.h"

#include <set>

namespace penumbra::study {

Recommendations recommendations(const techniques::TechniqueList& list) {
  Recommendations all;
  for (const techniques::Technique& technique : list.techniques)
    if (!technique.use_when.empty() || !technique.not_when.empty())
      all[technique.name] = {technique.use_when, technique.not_when};
  return all;
}

std::vector<RecommendedChoice> recommended(const Results& results, const Recommendations& recommendations) {
  std::vector<RecommendedChoice> all;
  std::set<std::string> seen;
  for (const Choice& choice : choices(results)) {
    const auto found = recommendations.find(choice.technique);
    if (found != recommendations.end() && seen.insert(choice.technique).second)
      all.push_back({choice, found->second});
  }
  return all;
}

}  // namespace penumbra::study
