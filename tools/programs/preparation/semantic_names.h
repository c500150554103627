// Which semantics a stage has. Internal to this room.
//
// https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-semantics; what vertices have in
// Unity: https://docs.unity3d.com/Manual/SL-VertexProgramInputs.html.
#pragma once

#include <string>
#include <string_view>

#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"
#include "preparation/number_shape.h"

namespace penumbra::preparation {

struct SemanticProblem {
  std::string words;  // behind the semantic's name; empty: there is none
  hlsl::Severity severity = hlsl::Severity::error;
};

// `semantic` as written, with its index.
SemanticProblem semantic_problem(const std::string& semantic, hlsl::Stage stage, bool input);

// What a value of that type says of a system value that is a whole number or a bool; empty: it fits.
std::string type_problem(const std::string& semantic, const NumberShape& type);

// In capitals, without its index: "SV_TARGET" of "SV_Target1".
std::string semantic_key(std::string_view semantic);

}  // namespace penumbra::preparation
