#include "study/recommendation.h"

namespace penumbra::study {

Recommendations recommendations(const techniques::TechniqueList& list) {
  Recommendations all;
  for (const techniques::Technique& technique : list.techniques)
    if (!technique.use_when.empty() || !technique.not_when.empty())
      all[technique.name] = {technique.use_when, technique.not_when};
  return all;
}

}  // namespace penumbra::study
