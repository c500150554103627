// register() annotations that say nothing here, or say it in a way glslang does not read. Bindings are
// numbered anew in the module and constants are found by reflection, so what a register says is the kind of a
// resource, which its type says too, and its space, which stays.
//
// - `register(ps_5_0, t0)` loses the profile, `register(s[2])` its brackets; of several the last stays.
// - `register(c3)`, `register(c1.y)`, `register(i0)` on what is no resource go: they place a constant in
//   Direct3D 9's registers, where glslang makes members overlap or stops at the '.'.
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-register)
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void plain_registers(TokenText& text);

}  // namespace penumbra::preparation
