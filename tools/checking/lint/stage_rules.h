// The rules of one compiled stage, which module_rules.cpp runs. Internal to this folder.
#pragma once

#include <string_view>
#include <vector>

#include "hlsl/stage.h"
#include "lint/source_place.h"

namespace penumbra::lint {

// Rules negative-pow and nan-check.
//
// Direct3D's compiler warns that pow(f, e) gives NaN for negative f wherever it cannot prove f >= 0 (X3571),
// and that isnan() may be removed because it assumes that no value is NaN (X3577); GLSL's pow is undefined
// for negative bases (GLSL 4.60 specification, 8.2).
// https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-pow
//
// `linted` is a legalised module.
std::vector<hlsl::Diagnostic> arithmetic_findings(const LintedCode& linted);

// Rule early-return: a function returns from within a condition. FXC then says that its result may be
// uninitialised (X4000), and may refuse it (X8000).
//
// FXC makes a branch of a condition with [branch], of one with texture reads, and of one whose function
// returns more than 16 components; it turns others into a choice of values, where nothing is left
// uninitialised. It knows every path where both sides return, and it treats returns from loops in another
// way. All of this has been tried with FXC 10.0.26100.
//
// `linted` is a module before inlining.
std::vector<hlsl::Diagnostic> early_return_findings(const LintedCode& linted);

// Rules divergent-derivative, gradient-in-varying-loop and unroll-without-bound.
//
// Implicit derivatives (Sample, SampleCmp, SampleBias, ddx, ddy, fwidth, CalculateLevelOfDetail) are only
// defined in uniform control flow within a quad (SPIR-V specification, "Derivatives"). Direct3D's compiler
// moves such an operation out of a divergent condition with a warning (X4121) and unrolls a loop around it
// with a divergent number of iterations (X3570), which fails if nothing bounds the iterations (X3511).
// https://learn.microsoft.com/windows/win32/direct3dhlsl/hlsl-errors-and-warnings
//
// `linted` is a legalised fragment shader.
std::vector<hlsl::Diagnostic> gradient_findings(const LintedCode& linted);

// Finds loops marked [unroll] without a constant bound, in any legalised stage.
std::vector<hlsl::Diagnostic> unroll_findings(const LintedCode& linted);

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

// Rule indexed-write: a vector's component, or a matrix's row, is written by index in a loop that FXC cannot
// unroll (X3500, X3511, X3531).
//
// FXC's vectors have no index that is computed at run time, so it unrolls the loop. That fails with [loop],
// and where a `continue` before the write depends on values that FXC does not know. Arrays can be indexed,
// and the write may stand within the condition in place of the `continue`. This was tried with FXC
// 10.0.26100.
//
// `linted` is a module before inlining.
std::vector<hlsl::Diagnostic> indexed_write_findings(const LintedCode& linted);

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

// Rules output-not-set and read-before-set.
//
// Direct3D's compiler rejects a function with a path that returns nothing (X3507) and an out parameter that
// is not completely assigned (X3508); it warns about a shader output that is not (X3578) and about variables
// that may be read uninitialised (X4000). glslang accepts all four.
// https://learn.microsoft.com/windows/win32/direct3dhlsl/hlsl-errors-and-warnings
//
// The module must have its functions and names (unoptimised).
std::vector<hlsl::Diagnostic> unset_values(const LintedCode& linted);

}  // namespace penumbra::lint
