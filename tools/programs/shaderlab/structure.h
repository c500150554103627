// Shader, Category, SubShader and Pass. Internal to this folder.
#pragma once

#include "shaderlab/cursor.h"

namespace penumbra::shaderlab {

// Fills all of the tree except its text and its include blocks; throws SyntaxError, after which the tree
// contains what was read so far.
void parse_structure(Cursor& cursor, Shader& shader);

}  // namespace penumbra::shaderlab
