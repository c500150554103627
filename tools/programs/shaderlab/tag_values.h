// The values of tags that Unity itself reads. Internal to this room.
//
// https://docs.unity3d.com/Manual/SL-SubShaderTags.html and SL-PassTags.html. An unknown value is no error in
// Unity: the tag then does nothing, or the SubShader is never chosen.
#pragma once

#include <string>

#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

// Why the tag's value does nothing; empty for one that is known, and for tags that take names of one's own.
std::string tag_problem(const Tag& tag);

}  // namespace penumbra::shaderlab
