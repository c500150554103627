// Unity's names for samplers: "sampler" + a texture's name uses that texture's settings; any other name must
// contain the settings, for example sampler_linear_clamp or My_Trilinear_ClampU_RepeatV_sampler.
//
// https://docs.unity3d.com/Manual/SL-SamplerStates.html: a filter mode (point, linear, trilinear) and a wrap
// mode (clamp, repeat, mirror, mirroronce, for single axes followed by U, V or W) are required, compare and
// aniso2 to aniso16 are optional; case and order do not matter.
#pragma once

#include <string_view>

namespace penumbra::lint {

// Returns whether the name holds a filter mode and a wrap mode.
bool is_inline_sampler(std::string_view name);

}  // namespace penumbra::lint
