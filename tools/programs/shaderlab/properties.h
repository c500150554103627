// The Properties block: https://docs.unity3d.com/Manual/SL-Properties.html. Internal to this folder.
#pragma once

#include "shaderlab/cursor.h"

namespace penumbra::shaderlab {

// Called after the word Properties; appends what its braces hold.
void parse_properties(Cursor& cursor, std::vector<Property>& properties);

}  // namespace penumbra::shaderlab
