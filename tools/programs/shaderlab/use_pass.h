// Finds the Pass that a UsePass names.
//
// UsePass "Shader/Name/PASSNAME" takes the Pass PASSNAME of the shader Shader/Name. Unity keeps the names of
// passes in upper case (https://docs.unity3d.com/Manual/SL-Name.html) and its manual requires that spelling
// here (https://docs.unity3d.com/Manual/SL-UsePass.html), which URP's own shaders do not follow: case is
// ignored. Names of shaders are case-sensitive. If several SubShaders have such a Pass, the first is taken;
// Unity takes the first SubShader that the device supports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

struct FoundPass {
  const Shader* shader = nullptr;  // the shader with the Pass; nullptr if there is none
  const SubShader* sub_shader = nullptr;
  const Pass* pass = nullptr;
  // The reason why there is none: a warning when the shader is not among those given (Unity may have it built
  // in), an error when it lacks the Pass.
  std::optional<hlsl::Diagnostic> diagnostic;
};

// `use` is a UsePass of `user`; if it refers to another UsePass, that one is resolved, too.
FoundPass resolve_use_pass(const Shader& user, const Pass& use, const std::vector<const Shader*>& shaders);

}  // namespace penumbra::shaderlab
