// GLSL's names of types and functions that HLSL names otherwise, for messages. Internal to this folder.
#pragma once

#include <string>
#include <string_view>

namespace penumbra::shaders {

// Returns HLSL's name; empty if GLSL has no such name, or HLSL the same.
std::string_view hlsl_name(std::string_view glsl);

}  // namespace penumbra::shaders
