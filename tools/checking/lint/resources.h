// Rules sampler-name, sampler-limit and register-limit. Internal to this folder.
//
// Resources count if the shader uses them after dead code elimination, as in the compilers that enforce the
// limits: https://learn.microsoft.com/windows/win32/direct3d11/overviews-direct3d-11-resources-limits and the
// constants of d3d11.h named in resources.cpp; interpolators by `#pragma target` after
// https://docs.unity3d.com/Manual/SL-ShaderCompileTargets.html and SL-Pragma-require.html.
#pragma once

#include <vector>

#include "hlsl/stage.h"
#include "lint/source_place.h"

namespace penumbra::lint {

// `linted` is a legalised module. shader_target is ten times `#pragma target`, and 0 for none.
std::vector<hlsl::Diagnostic> resource_findings(const LintedCode& linted, hlsl::Stage stage,
                                                int shader_target);

}  // namespace penumbra::lint
