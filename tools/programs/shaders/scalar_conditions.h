// any(x) and all(x) of a scalar, which HLSL has
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-any). glslang writes OpAny and OpAll for
// them all the same, and these take vectors alone (SPIR-V specification 3.42.15); of one bool they are that
// bool.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// OpAny and OpAll of one bool become OpCopyObject.
void copy_scalar_conditions(SpirvModule& module);

}  // namespace penumbra::shaders
