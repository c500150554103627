// Rule early-return: a function returns from within a condition. FXC then says that its result may be
// uninitialised (X4000), and may refuse it (X8000). Internal to this folder.
//
// FXC makes a branch of a condition with [branch], of one with texture reads, and of one whose function
// returns more than 16 components; it turns others into a choice of values, where nothing is left
// uninitialised. It knows every path where both sides return, and it treats returns from loops in another
// way. All of this has been tried with FXC 10.0.26100.
#pragma once

#include <vector>

#include "lint/source_place.h"

namespace penumbra::lint {

// `linted` is a module before inlining.
std::vector<hlsl::Diagnostic> early_return_findings(const LintedCode& linted);

}  // namespace penumbra::lint
