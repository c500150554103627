#include "variants/keyword_set.h"

#include <algorithm>
#include <set>

namespace penumbra::variants {

bool is_empty_keyword(const std::string& name) {
  return !name.empty() && name.find_first_not_of('_') == std::string::npos;
}

bool contains(const Keywords& keywords, const std::string& keyword) {
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

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
