// Inputs and outputs with types that HLSL allows and Vulkan, OpenGL and Metal do not (GLSL 4.50, 4.3.4; VUID
// StandaloneSpirv-Input-07290).
//
// - `bool lit : TEXCOORD1`, `bool2`, ...: passed as uint, as in Direct3D's interface; reads convert to bool,
//   writes to 0 and 1.
// - `uint front : SV_IsFrontFace`: becomes bool, which is 0 or 1 when used as a number. A warning says that
//   true is 0xFFFFFFFF in Direct3D.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void pass_bools_as_numbers(TokenText& text);

}  // namespace penumbra::preparation
