// The rules on the text of a shader, which runs through no compiler: groupshared-initialiser and
// unity-version.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"

namespace penumbra::lint {

// Rule groupshared-initialiser: with FXC every thread writes the value when it starts, over what others have
// written since, and DXC ignores it.
//
// `expanded` is without comments and macros, with #line directives (hlsl/tokens.h); lines before the first
// that names a file are in `main_file`. There is one finding for each place.
std::vector<hlsl::Diagnostic> groupshared_initialiser_findings(const std::string& expanded,
                                                               const std::string& main_file,
                                                               const hlsl::SourceFiles& sources);

// Rule unity-version: a condition compares UNITY_VERSION with a number that has the digits of a version of
// Unity, but not their form, which is YYYYMP up to 2023 and 6MMMPPPP from Unity 6 on
// (https://docs.unity3d.com/6000.0/Documentation/Manual/shader-branching-unity-version.html). Conditions
// count whether or not this variant reaches them.
std::vector<hlsl::Diagnostic> unity_version_findings(const hlsl::SourceFiles& sources);
bool compares_unity_version(std::string_view source);  // true if a finding could be in this text

// Both of these.
std::vector<hlsl::Diagnostic> text_findings(const std::string& expanded, const std::string& main_file,
                                            const hlsl::SourceFiles& sources);

}  // namespace penumbra::lint
