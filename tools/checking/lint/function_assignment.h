// Definite assignment within one function, given what the functions it calls do. Internal to this room; see
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

// `is_out` by parameter; a call of a function without an effect is taken to set and read nothing.
FunctionResult function_assignment(const spirv::Code& code, const spirv::Function& function,
                                   const std::vector<bool>& is_out,
                                   const std::map<spirv::Id, FunctionEffect>& effects);

}  // namespace penumbra::lint
