// The rules of one compiled stage, which module_rules.cpp runs. Internal to this folder.
#pragma once

#include <string_view>
#include <vector>

#include "hlsl/stage.h"
#include "lint/source_place.h"

namespace penumbra::lint {

// Rule divergent-derivative.
//
// Implicit derivatives (Sample, SampleCmp, SampleBias, ddx, ddy, fwidth, CalculateLevelOfDetail) are only
// defined in uniform control flow within a quad (SPIR-V specification, "Derivatives"). In a loop with a
// divergent number of iterations FXC itself reports them (X3570, X3511, X4014); it moves others out of a
// divergent condition, often without its warning X4121.
// https://learn.microsoft.com/windows/win32/direct3dhlsl/hlsl-errors-and-warnings
//
// `linted` is a legalised fragment shader.
std::vector<hlsl::Diagnostic> derivative_findings(const LintedCode& linted);

// Rule divergent-barrier: a barrier that waits for the threads of a group must be reached by all of them
// (Direct3D X3663). `linted` is a legalised compute shader.
std::vector<hlsl::Diagnostic> barrier_findings(const LintedCode& linted);

// Rule missing-barrier: a thread reads from group shared memory what another writes, and no barrier with
// group sync is on a path between them. Threads and elements are compared by value (thread_values.h), so a
// read by an index that is neither known from the thread's number nor the same for the group is not reported;
// nor are shaders with wave operations, which may order threads otherwise. `linted` is a legalised compute
// shader.
std::vector<hlsl::Diagnostic> missing_barrier_findings(const LintedCode& linted);

// Rule lane-order: a calculation or comparison mixes a lane's number, or the number of lanes, with the number
// of a thread in its group. `linted` is a legalised compute shader.
std::vector<hlsl::Diagnostic> lane_order_findings(const LintedCode& linted);

// Rules sampler-name, sampler-limit, register-limit and typed-load.
//
// Resources count if the shader uses them after dead code elimination, as in the compilers that enforce the
// limits: https://learn.microsoft.com/windows/win32/direct3d11/overviews-direct3d-11-resources-limits and the
// constants of d3d11.h named in resources.cpp; interpolators by `#pragma target` after
// https://docs.unity3d.com/Manual/SL-ShaderCompileTargets.html and SL-Pragma-require.html.
//
// `linted` is a legalised module. shader_target is ten times `#pragma target`, and 0 for none.
std::vector<hlsl::Diagnostic> resource_findings(const LintedCode& linted, hlsl::Stage stage,
                                                int shader_target);

// Unity's names for samplers: "sampler" + a texture's name uses that texture's settings; any other name must
// contain the settings, for example sampler_linear_clamp or My_Trilinear_ClampU_RepeatV_sampler.
// https://docs.unity3d.com/Manual/SL-SamplerStates.html: a filter mode (point, linear, trilinear) and a wrap
// mode (clamp, repeat, mirror, mirroronce, for single axes followed by U, V or W) are required, compare and
// aniso2 to aniso16 are optional; case and order do not matter.
// Returns whether the name holds a filter mode and a wrap mode.
bool is_inline_sampler(std::string_view name);

}  // namespace penumbra::lint
