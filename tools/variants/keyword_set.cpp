#include "variants/keyword_set.h"

#include <set>

namespace penumbra::variants {

Keywords keywords_of(const KeywordSet& set) {
  Keywords keywords;
  std::set<std::string> seen;
  for (const Keywords& alternative : set.alternatives)
    for (const std::string& keyword : alternative)
      if (seen.insert(keyword).second) keywords.push_back(keyword);
  return keywords;
}

std::string label_of(const KeywordSet& set) {
  std::string label;
  for (const Keywords& alternative : set.alternatives) {
    if (!label.empty()) label += ' ';
    if (alternative.empty()) label += '_';
    for (std::size_t i = 0; i < alternative.size(); ++i) label += (i == 0 ? "" : "+") + alternative[i];
  }
  return label;
}

}  // namespace penumbra::variants
