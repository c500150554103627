// Which semantics a stage has. Internal to this room.
//
// https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-semantics; what vertices have in
// Unity: https://docs.unity3d.com/Manual/SL-VertexProgramInputs.html.
#pragma once

#include <string>

#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"

namespace penumbra::preparation {

struct SemanticProblem {
  std::string words;  // behind the semantic's name; empty: there is none
  hlsl::Severity severity = hlsl::Severity::error;
};

// `semantic` as written, with its index.
SemanticProblem semantic_problem(const std::string& semantic, hlsl::Stage stage, bool input);

}  // namespace penumbra::preparation
