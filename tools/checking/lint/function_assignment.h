// Definite assignment within one function, given the effects of its callees. Internal to this folder; see
// assignment_flow.h.
#pragma once

#include <map>
#include <vector>

#include "lint/assignment_flow.h"

namespace penumbra::lint {

struct FunctionResult {
  AssignmentFindings findings;
  FunctionEffect effect;
};

// `is_out` is indexed by parameter; a call of a function without a known effect assigns and reads nothing.
FunctionResult function_assignment(const spirv::Code& code, const spirv::Function& function,
                                   const std::vector<bool>& is_out,
                                   const std::map<spirv::Id, FunctionEffect>& effects);

}  // namespace penumbra::lint
