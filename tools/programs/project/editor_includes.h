// The include files that ship with the Unity editor (Editor/Data/CGIncludes; Contents/CGIncludes on macOS)
// and in no package: the union of the built-in shader archives that Unity publishes with its editors, 3.4 to
// 6000.5.
#pragma once

#include <string_view>

namespace penumbra::project {

// Returns the table's spelling of an editor-only include ("UnityCG.cginc" for "unitycg.cginc"); empty if it
// is not one, or has a folder before it.
std::string_view editor_include(std::string_view name);

}  // namespace penumbra::project
