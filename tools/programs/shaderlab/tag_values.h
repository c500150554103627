// The values of tags that Unity itself interprets. Internal to this folder.
//
// https://docs.unity3d.com/Manual/SL-SubShaderTags.html and SL-PassTags.html. Unity accepts an unknown value:
// the tag then has no effect, or the SubShader is never selected.
#pragma once

#include <string>

#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

// Says why the tag's value has no effect; empty for a known one, and for tags with arbitrary names.
std::string tag_problem(const Tag& tag);

}  // namespace penumbra::shaderlab
