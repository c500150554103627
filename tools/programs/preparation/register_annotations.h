// register() annotations that have no effect here, or a syntax that glslang does not parse. Bindings are
// renumbered in the module and constants are found by reflection, so a register only determines the kind of a
// resource, which follows from its type, and its space, which is kept.
//
// - `register(ps_5_0, t0)` loses the profile, `register(s[2])` its brackets; of several the last is kept.
// - `register(c3)`, `register(c1.y)`, `register(i0)` on anything but a resource are removed: they place a
//   constant in Direct3D 9's registers, for which glslang overlaps members or reports the '.'.
//
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-register)
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void plain_registers(TokenText& text);

}  // namespace penumbra::preparation
