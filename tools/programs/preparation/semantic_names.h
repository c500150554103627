// The semantics that a stage has. Internal to this folder.
//
// https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-semantics; vertex attributes in
// Unity: https://docs.unity3d.com/Manual/SL-VertexProgramInputs.html.
#pragma once

#include "hlsl/stage.h"
#include "preparation/number_shape.h"

namespace penumbra::preparation {

// Each returns what is wrong with a semantic as written, with its index: words that follow it in a message;
// empty if nothing is. glslang crashes on the distances, and an attribute of a vertex program's input is a
// warning.
std::string semantic_problem(const std::string& semantic, hlsl::Stage stage, bool input);
std::string distance_problem(const std::string& semantic, hlsl::Stage stage, bool input);
std::string attribute_problem(const std::string& semantic);

// Returns the system value that FXC's compatibility mode, in which Unity runs it, reads in a name of Direct3D
// 9: POSITION of a vertex program's outputs, VPOS of a fragment program's inputs, COLOR and DEPTH of its
// outputs. It has the index; it is empty for other names. DXC's -Gec has the same rules
// (RemapObsoleteSemantic in DxilTypeSystem.cpp).
std::string system_value_of(const std::string& semantic, hlsl::Stage stage, bool input);

// Describes the problem with a value of that type for a system value that is an integer or a bool; empty if
// there is none.
std::string type_problem(const std::string& semantic, const NumberShape& type);

// Returns the name in upper case, without its index: "SV_TARGET" for "SV_Target1".
std::string semantic_key(std::string_view semantic);

// The place where a source declares a semantic of its entry point.
struct SemanticPlace {
  std::string semantic;  // the semantic as written
  bool output = false;
  std::string file;
  int line = 0;
};

}  // namespace penumbra::preparation
