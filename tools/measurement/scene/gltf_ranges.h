// A check of the ranges that a glTF file reads of its buffers. The importer library adds the offsets of a
// file without a check that the sum is inside: a large one wraps around, and bytes before or behind the
// buffer become vertices. Internal to this folder.
#pragma once

#include <filesystem>

namespace penumbra::scene {

// Throws InputError, at the line, where a view lies outside of its buffer, an accessor outside of its view,
// or an embedded buffer is shorter than it says; also where the JSON is broken. It reads glTF 1 and 2, with
// JSON alone or in a container, whatever the file's name: the library also tries the contents of a file whose
// ending is another format's. Does nothing for other formats.
void check_gltf_ranges(const std::filesystem::path& file);

}  // namespace penumbra::scene
