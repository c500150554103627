// The components of a function's local variables and out parameters that are definitely assigned at a point.
// Internal to this folder.
//
// Definite assignment is that of Java's language specification (chapter 16) for locals, here for single
// components: a component is assigned if every path from the function's entry to the point stores it. Copies
// propagate unassigned components; a read is where a value is used. The analysis is interprocedural: the
// parameters' components that a callee assigns and reads are computed first. An element with a dynamic index
// counts as assigned once any element is, so arrays filled in a loop are not reported.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "lint/components.h"
#include "spirv/code.h"

namespace penumbra::lint {

// A use of components that some path leaves unset.
struct UnsetRead {
  spirv::Id variable = 0;  // a local or parameter; 0 for the value that a callee returned
  spirv::Id callee = 0;  // that callee, or the one that reads the variable it is given; 0 for a read in place
  spirv::Id type = 0;
  Components known;       // false for components that are read though unset
  bool ever_set = false;  // the function stores to some of them somewhere
  spirv::Place place;
};

// Components of an out parameter or the result that some path leaves unset.
struct UnsetOutput {
  spirv::Id parameter = 0;  // 0 for the result
  spirv::Id type = 0;
  Components set;
  bool nothing_returned = false;  // a path ends without a return statement
  bool ever_set = false;          // the function sets each component on some path
  spirv::Place place;
};

// The effect of a call on each argument.
struct ParameterEffect {
  bool is_out = false;
  Components read;  // components that are read before being set; meaningless for out
  Components set;   // components that are set on every path to the end
};
struct FunctionEffect {
  std::vector<ParameterEffect> parameters;
  Components result;  // set components of a returned struct or array; empty means all
};

struct AssignmentFindings {
  std::vector<UnsetRead> reads;
  std::vector<UnsetOutput> outputs;
  bool too_large = false;
};

// Returns the findings of every function except the entry point's wrapper, which only copies, in the order of
// the module.
std::map<spirv::Id, AssignmentFindings> assignment_findings(const spirv::Code& code);

}  // namespace penumbra::lint
