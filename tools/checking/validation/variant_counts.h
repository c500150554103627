// How many variants programs have, as `penumbra validate --count` says it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/shader_sources.h"
#include "variants/clause.h"
#include "variants/plan.h"

namespace penumbra::validation {

struct VariantCounts {
  variants::Plan plan;
  std::optional<variants::Plan> what_if;  // of the same programs
  std::string condition;                  // as it was asked for: "-_FOAM"
};

// {programs: [{file, shader, pass, api, stages: [{stage, variants, what_if}]}], variants, what_if,
// condition}: what_if and condition where they were asked for, shader and pass where there is one. A count of
// 2^64 - 1 stands for that or more.
std::string counts_json(const ShaderSources& sources, const VariantCounts& counts);

}  // namespace penumbra::validation
