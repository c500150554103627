// The numbers of variants that programs have, as `penumbra validate --count` prints them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/shader_sources.h"
#include "variants/keyword_set.h"
#include "variants/plan.h"

namespace penumbra::validation {

struct VariantCounts {
  variants::Plan plan;
  std::optional<variants::Plan> what_if;  // the plan of the same programs
  std::string condition;                  // the condition as given: "-_FOAM"
};

// Returns {programs: [{file, shader, pass, api, stages: [{stage, variants, what_if}]}], results, what_if,
// condition}: what_if and condition if they were requested, shader and pass where there is one. A count of
// 2^64 - 1 stands for that or more.
std::string counts_json(const ShaderSources& sources, const VariantCounts& counts);

}  // namespace penumbra::validation
