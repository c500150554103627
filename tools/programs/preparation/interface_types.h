// Inputs and outputs of types that HLSL has and Vulkan, OpenGL and Metal do not (GLSL 4.50, 4.3.4; VUID
// StandaloneSpirv-Input-07290).
//
// - `bool lit : TEXCOORD1`, `bool2`, ...: passed as uint, of which Direct3D's interface consists, too; what
//   reads it makes it a bool again, what writes it 0 and 1.
// - `uint front : SV_IsFrontFace`: bool, which a use in a number makes 0 or 1. A warning says that true is
//   0xFFFFFFFF in Direct3D.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void pass_bools_as_numbers(TokenText& text);

}  // namespace penumbra::preparation
