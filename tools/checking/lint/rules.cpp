#include "lint/rule.h"

#include <algorithm>

namespace penumbra::lint {

namespace {

using hlsl::Severity;

constexpr const char* d3d_messages =
    "https://learn.microsoft.com/windows/win32/direct3dhlsl/hlsl-errors-and-warnings";
constexpr const char* d3d_limits =
    "https://learn.microsoft.com/windows/win32/direct3d11/overviews-direct3d-11-resources-limits";
constexpr const char* spirv_derivatives =
    "SPIR-V specification, Derivative Control and Uniform Control Flow: "
    "https://registry.khronos.org/SPIR-V/specs/unified1/SPIRV.html";

}  // namespace

const std::vector<RuleInfo>& rules() {
  static const std::vector<RuleInfo> all{
      {"divergent-derivative", Severity::warning,
       "A derivative is taken where only some pixels of a quad may be active.",
       std::string("Direct3D X4121; ") + spirv_derivatives},
      {"divergent-barrier", Severity::error,
       "A barrier with group sync is in divergent control flow: not all threads of a group reach it.",
       std::string("Direct3D X3663: ") + d3d_messages},
      {"missing-barrier", Severity::warning,
       "A thread reads from group shared memory what another writes, without a barrier between.",
       "https://learn.microsoft.com/windows/win32/direct3dhlsl/groupmemorybarrierwithgroupsync"},
      {"lane-order", Severity::warning,
       "A lane's number is mixed with that of a thread in its group, which HLSL does not relate.",
       "https://microsoft.github.io/hlsl-specs/proposals/0048-group-wave-index"},
      {"groupshared-initialiser", Severity::warning,
       "A groupshared variable has an initialiser, which every thread writes, or none.",
       "https://github.com/llvm/llvm-project/pull/184459"},
      {"unity-version", Severity::warning, "UNITY_VERSION is compared with a number that is no version.",
       "https://docs.unity3d.com/6000.0/Documentation/Manual/shader-branching-unity-version.html", true},
      {"sampler-name", Severity::error,
       "A sampler's name identifies neither a texture nor sampler settings to Unity.",
       "https://docs.unity3d.com/Manual/SL-SamplerStates.html", true},
      {"sampler-limit", Severity::error, "More samplers are used than Direct3D 11 has.", d3d_limits},
      {"register-limit", Severity::error,
       "More textures, buffers, constant buffer bytes, interpolators or bytes of group shared memory are "
       "used than Direct3D 11 or the "
       "shader's #pragma target has.",
       std::string(d3d_limits) + " and https://docs.unity3d.com/Manual/SL-ShaderCompileTargets.html"},
      {"typed-load", Severity::warning,
       "A writable texture or buffer is read whose format Direct3D 11 does not promise to read.",
       "https://learn.microsoft.com/windows/win32/direct3d11/typed-unordered-access-view-loads"},
      {"interpolated-cascade", Severity::warning,
       "A fragment program reads URP's shadow coordinate, which a vertex program calculates with cascades.",
       "https://github.com/Unity-Technologies/Graphics/pull/4447", true},
      {"property-type", Severity::warning, "A material property's type does not fit its variable.",
       "https://docs.unity3d.com/6000.0/Documentation/Manual/SL-PropertiesInPrograms.html", true},
      {"srp-batcher", Severity::warning,
       "Material properties outside of UnityPerMaterial, or a UnityPerMaterial that differs between passes.",
       "https://docs.unity3d.com/Manual/SRPBatcher-Materials.html", true},
      {"unused-keyword", Severity::warning, "A keyword is declared and changes no variant.",
       "https://docs.unity3d.com/Manual/shader-keywords.html", true},
      {"unknown-rule", Severity::warning, "A comment disables a rule that does not exist.", "docs/lint.md"},
      {"not-checked", Severity::note, "A shader is too large for the rules that analyse control flow.",
       "docs/lint.md"}};
  return all;
}

const RuleInfo* find_rule(const std::string& name) {
  const auto found =
      std::find_if(rules().begin(), rules().end(), [&](const RuleInfo& rule) { return rule.name == name; });
  return found == rules().end() ? nullptr : &*found;
}

}  // namespace penumbra::lint
