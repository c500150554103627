// The checked-in texts of parameter structs: in HLSL a file for each beside its manifest, in C# one of
// several in Runtime/Parameters. Both hold the struct and the same packing (parameter_packing.h).
#pragma once

#include <string>
#include <vector>

#include "techniques/parameter_packing.h"

namespace penumbra::techniques {

// A text that is made from the manifests and checked in.
struct EmittedFile {
  std::string file;  // path relative to the package's folder
  std::string text;
};

EmittedFile emit_hlsl(const ParameterStruct& parameters);
EmittedFile emit_csharp(const std::vector<ParameterStruct>& structs, const std::string& name);

}  // namespace penumbra::techniques
