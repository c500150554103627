// The lint rules: name, severity, description and source of each.
//
// docs/lint.md has one section for each; a test compares the two lists.
#pragma once

#include <string>
#include <vector>

#include "hlsl/diagnostic.h"

namespace penumbra::lint {

struct RuleInfo {
  std::string name;                                   // kebab-case, as suppressions and reports spell it
  hlsl::Severity severity = hlsl::Severity::warning;  // the highest that it reports
  std::string summary;                                // the description, one sentence
  std::string source;                                 // the page or section that documents it
  bool of_unity = false;                              // about what Unity makes of a name or a pragma
};

// The rules are in the order of the documentation.
const std::vector<RuleInfo>& rules();
const RuleInfo* find_rule(const std::string& name);

}  // namespace penumbra::lint
