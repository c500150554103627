// Which semantics a stage has. Internal to this room.
//
// https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-semantics; vertex attributes in
// Unity: https://docs.unity3d.com/Manual/SL-VertexProgramInputs.html.
#pragma once

#include <string>
#include <string_view>

#include "hlsl/stage.h"
#include "preparation/number_shape.h"

namespace penumbra::preparation {

// Problems with a semantic as written, with its index: words that follow it in a message; empty: none.
std::string semantic_problem(const std::string& semantic, hlsl::Stage stage, bool input);
std::string distance_problem(const std::string& semantic, hlsl::Stage stage, bool input);  // crashes glslang
std::string attribute_problem(const std::string& semantic);  // of a vertex program's input; a warning

// The system value that FXC's compatibility mode, in which Unity runs it, reads in a name of Direct3D 9:
// POSITION of a vertex program's outputs, VPOS of a fragment program's inputs, COLOR and DEPTH of its
// outputs. With the index; empty for other names. As DXC's -Gec has it (RemapObsoleteSemantic in
// DxilTypeSystem.cpp).
std::string system_value_of(const std::string& semantic, hlsl::Stage stage, bool input);

// The problem with a value of that type for a system value that is an integer or a bool; empty: none.
std::string type_problem(const std::string& semantic, const NumberShape& type);

// In upper case, without its index: "SV_TARGET" of "SV_Target1".
std::string semantic_key(std::string_view semantic);

}  // namespace penumbra::preparation
