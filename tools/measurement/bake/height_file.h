// The JSON file of a height field, which names its picture. Internal to this folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "bake/height_field.h"
#include "bake/height_source.h"

namespace penumbra::bake {

inline constexpr const char* height_field_kind = "height-field";
inline constexpr int baked_version = 1;  // version of the format of all bakes
inline constexpr const char* hashes_key =
    "picture_hashes";  // key of the pictures' hashes, by the pictures' names

struct HeightFile {
  std::filesystem::path picture;  // name within the folder of the JSON file
  HeightRange range;              // metres of the picture's 0 and 65535
  Area area;
  int holes = 0;         // samples without a surface, as the file says; the picture says of how many
  std::string holes_at;  // file:line:column
};

// Throws InputError at the JSON's line, and for a picture whose hash is not the one that the JSON was written
// with.
HeightFile read_height_file(const std::filesystem::path& json);

}  // namespace penumbra::bake
