// The semantics that a stage has. Internal to this folder.
//
// https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-semantics; vertex attributes in
// Unity: https://docs.unity3d.com/Manual/SL-VertexProgramInputs.html.
#pragma once

#include <string>
#include <string_view>

#include "hlsl/stage.h"

namespace penumbra::preparation {

// Returns what is wrong with a clip or cull distance, on which glslang crashes: words that follow the name in
// a message; empty if nothing is.
std::string distance_problem(const std::string& semantic, hlsl::Stage stage, bool input);

// Returns the system value that FXC's compatibility mode, in which Unity runs it, reads in a name of Direct3D
// 9: POSITION of a vertex program's outputs, VPOS of a fragment program's inputs, COLOR and DEPTH of its
// outputs. It has the index; it is empty for other names. DXC's -Gec has the same rules
// (RemapObsoleteSemantic in DxilTypeSystem.cpp).
std::string system_value_of(const std::string& semantic, hlsl::Stage stage, bool input);

// The place where a source declares a semantic of its entry point.
struct SemanticPlace {
  std::string semantic;  // the semantic as written
  bool output = false;
  std::string file;
  int line = 0;
};

}  // namespace penumbra::preparation
