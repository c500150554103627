// The checked-in texts of a parameter struct: in HLSL beside its manifest, in C# in Runtime/Parameters. Both
// hold the struct and the same packing (parameter_packing.h).
#pragma once

#include "techniques/parameter_packing.h"

namespace penumbra::techniques {

// A text that is made from the manifests and checked in.
struct EmittedFile {
  std::string file;  // path relative to the package's folder
  std::string text;
};

EmittedFile emit_hlsl(const ParameterStruct& parameters);
EmittedFile emit_csharp(const ParameterStruct& parameters);

}  // namespace penumbra::techniques
