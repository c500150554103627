// The profile that Unity gives FXC.
#pragma once

#include <string>

#include "hlsl/stage.h"

namespace penumbra::fxc {

// Returns "ps_4_0" and similar. Compute and tessellation are shader model 5.0, and so are all stages of a
// program with `#pragma target 4.5` or more; others are 4.0. shader_target is ten times the target, and 0 if
// none was given. Source: Unity Manual, "Targeting shader models and GPU features".
std::string profile_for(hlsl::Stage stage, int shader_target);

}  // namespace penumbra::fxc
