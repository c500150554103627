// Comments that silence a rule where it is known to be wrong:
//
//   // penumbra-lint: disable=rule-name[,rule-name...]        this line, or the next when it stands alone
//   // penumbra-lint: disable-file=rule-name[,rule-name...]   this file
//
// Read from the texts as they were written, before any preprocessing.
#pragma once

#include <vector>

#include "hlsl/source_text.h"
#include "lint/rule.h"

namespace penumbra::lint {

// The findings that no comment at their own place silences. A finding without a line is silenced by
// disable-file alone.
std::vector<Finding> without_suppressed(std::vector<Finding> findings, const hlsl::SourceFiles& sources);

// Comments that name no rule there is: a suppression that does nothing looks like one that does.
std::vector<Finding> unknown_suppressions(const hlsl::SourceFiles& sources);

}  // namespace penumbra::lint
