// Rule divergent-barrier: a barrier that waits for the threads of a group must be reached by all of them
// (Direct3D X3663). Internal to this folder.
#pragma once

#include <vector>

#include "lint/source_place.h"

namespace penumbra::lint {

// `linted` is a legalised compute shader.
std::vector<hlsl::Diagnostic> barrier_findings(const LintedCode& linted);

}  // namespace penumbra::lint
