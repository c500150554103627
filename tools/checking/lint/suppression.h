// Comments that suppress a rule where it is known to be wrong:
//
//   // penumbra-lint: disable=rule-name[,rule-name...]        this line, or the next one if it has no code
//   // penumbra-lint: disable-file=rule-name[,rule-name...]   this file
//
// They are read from the original texts, before any preprocessing.
#pragma once

#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"

namespace penumbra::lint {

// Returns the findings that no comment at their location suppresses. A finding without a line is suppressed
// only by disable-file.
std::vector<hlsl::Diagnostic> without_suppressed(std::vector<hlsl::Diagnostic> findings,
                                                 const hlsl::SourceFiles& sources);

// Reports comments that name an unknown rule: a suppression without effect looks like one that works.
std::vector<hlsl::Diagnostic> unknown_suppressions(const hlsl::SourceFiles& sources);

}  // namespace penumbra::lint
