// Rule indexed-write: a vector's component, or a matrix's row, is written by index in a loop that FXC cannot
// unroll (X3500, X3511, X3531). Internal to this folder.
//
// FXC's vectors have no index that is computed at run time, so it unrolls the loop. That fails with [loop],
// and where a `continue` before the write depends on values that FXC does not know. Arrays can be indexed,
// and the write may stand within the condition in place of the `continue`. This was tried with FXC
// 10.0.26100.
#pragma once

#include <vector>

#include "lint/source_place.h"

namespace penumbra::lint {

// `linted` is a module before inlining.
std::vector<hlsl::Diagnostic> indexed_write_findings(const LintedCode& linted);

}  // namespace penumbra::lint
