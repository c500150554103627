// Rule reserved-name: a name that is a reserved word of FXC, Unity's compiler (X3000).
//
// The words are those that FXC 10.0.26100 refuses and glslang takes. Only names that are declared count: some
// words mean something elsewhere (`: register(t0)`).
#pragma once

#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"

namespace penumbra::lint {

// `expanded` is without comments and macros, with #line directives (hlsl/tokens.h); lines before the first
// that names a file are in `main_file`. There is one finding for each place.
std::vector<hlsl::Diagnostic> reserved_name_findings(const std::string& expanded,
                                                     const std::string& main_file,
                                                     const hlsl::SourceFiles& sources);

}  // namespace penumbra::lint
