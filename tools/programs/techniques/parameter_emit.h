// The checked-in texts of a parameter struct: in HLSL beside its manifest, in C# in Runtime/Parameters. Both
// hold the struct and the same packing (parameter_packing.h).
#pragma once

#include "techniques/emitted_file.h"
#include "techniques/parameter_struct.h"

namespace penumbra::techniques {

EmittedFile emit_hlsl(const ParameterStruct& parameters);
EmittedFile emit_csharp(const ParameterStruct& parameters);

}  // namespace penumbra::techniques
