// Which semantics a stage has. Internal to this room.
//
// https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-semantics; vertex attributes in
// Unity: https://docs.unity3d.com/Manual/SL-VertexProgramInputs.html.
#pragma once

#include <string>
#include <string_view>

#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"
#include "preparation/number_shape.h"

namespace penumbra::preparation {

struct SemanticProblem {
  std::string words;  // follows the semantic's name; empty: no problem
  hlsl::Severity severity = hlsl::Severity::error;
  bool crashes = false;  // glslang, which must not see it
};

// `semantic` as written, with its index.
SemanticProblem semantic_problem(const std::string& semantic, hlsl::Stage stage, bool input);

// The problem with a value of that type for a system value that is an integer or a bool; empty: none.
std::string type_problem(const std::string& semantic, const NumberShape& type);

// In upper case, without its index: "SV_TARGET" of "SV_Target1".
std::string semantic_key(std::string_view semantic);

}  // namespace penumbra::preparation
