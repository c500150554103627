// Render state and legacy fixed-function commands, in their general shape. Internal to this room.
//
// Which values a command takes follows Unity's reference
// (https://docs.unity3d.com/Manual/shader-shaderlab-commands.html,
// https://docs.unity3d.com/Manual/SL-LegacyReference.html). A word that is none of a command's values is an
// error, as it is in Unity (command_values.h); numbers are not checked.
#pragma once

#include <string>
#include <vector>

#include "shaderlab/cursor.h"

namespace penumbra::shaderlab {

bool at_command(const Cursor& cursor);  // the next word is a command of a Pass, SubShader or Category

// The command that stands next, with its values and block.
Command parse_command(Cursor& cursor);

// Reports the word that stands next and steps over it, over values on its line and over its block.
// `structure`: words other than commands that might have been meant. A block that holds a program ends the
// parse: the program would be lost.
void skip_unknown_command(Cursor& cursor, const std::vector<std::string>& structure);

}  // namespace penumbra::shaderlab
