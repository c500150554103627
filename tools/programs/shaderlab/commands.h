// Render state and legacy fixed-function commands, in their general shape. Internal to this folder.
//
// The values of a command follow Unity's reference
// (https://docs.unity3d.com/Manual/shader-shaderlab-commands.html,
// https://docs.unity3d.com/Manual/SL-LegacyReference.html). A name that is not among a command's values is an
// error, as in Unity (command_values.h); numbers are not checked.
#pragma once

#include "shaderlab/cursor.h"

namespace penumbra::shaderlab {

bool at_command(const Cursor& cursor);  // the next token is a command of a Pass, SubShader or Category

// Parses the next command, with its values and block.
Command parse_command(Cursor& cursor);

// Reports the next token and skips it, with values on its line and its block. `structure` has keywords other
// than commands that might have been meant. A block that contains a program ends the parse, because the
// program would be lost.
void skip_unknown_command(Cursor& cursor, const std::vector<std::string>& structure);

}  // namespace penumbra::shaderlab
