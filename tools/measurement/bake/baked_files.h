// Bakes as files: PNG with 16 bits a channel, and a JSON file beside it that says what the numbers mean.
// Unity imports the PNG as R16 or RGBA64 textures; sRGB and compression have to be off.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "bake/distance_field.h"
#include "bake/field_objects.h"
#include "bake/height_field.h"
#include "bake/height_source.h"
#include "bake/horizon_angles.h"
#include "scene/reading_process.h"

namespace penumbra::bake {

// A JSON file, and the pictures that it names, which lie in its folder.
struct BakedFiles {
  std::string json;
  std::map<std::string, std::vector<std::byte>> pictures;  // keyed by file name
};

// Throws InputError for a stem that JSON cannot hold, because it is not UTF-8: baked_files() needs another.
void check_stem(const std::string& stem);

// The stem begins the pictures' names. The smallest z is at a picture's bottom, as Unity's textures have it.
// Heights become steps of (high - low) / 65535 of the field's own range. Angles become steps of a quarter
// turn / 65535, four directions in each of two pictures. Distances become steps of twice the largest / 65535;
// the slices of one z lie side by side in rows from the top, as Unity's importer of 3D textures takes them.
// These functions throw InputError for a picture of more than 16384 texels per side.
BakedFiles baked_files(const HeightField& field, const std::string& stem);
BakedFiles baked_files(const HorizonAngles& angles, const std::string& stem);
BakedFiles baked_files(const DistanceField& field, const std::string& stem);
BakedFiles baked_files(const ObjectFields& fields, const std::string& stem);

// Writes all of the files or none, and throws as write_files_atomically(). The JSON file, which holds a hash
// of each picture, is written last: if the machine stops in between, reading refuses what is left.
void write_baked_files(const BakedFiles& files, const std::filesystem::path& json);

// A height field that baked_files() wrote. Throws InputError at the JSON's line, and naming the picture where
// that is broken or is not the one that the JSON file was written with.
HeightField read_height_field(const std::filesystem::path& json, const scene::ReadingProcess& process);

// The picture has width * height * channels samples, rows from the bottom, as in Unity's textures; 1 channel
// is grey, 4 are RGBA. The same samples give the same bytes. Throws std::invalid_argument where the samples
// do not fit.
std::vector<std::byte> encode_png_16(int width, int height, int channels,
                                     std::span<const std::uint16_t> samples);

// Bakes as texels of 16 bits, as files and textures hold them: 8 bits are steps of 0.35 degrees of a quarter
// turn, wider than the sun.
//
// Rows run from the smallest z, as in Unity's textures; the first texel is that of the smallest x.
inline constexpr int horizon_channels = 4;  // directions in one texture

// Returns the step of 65535 that is nearest to a share of [0, 1]; values outside go to the ends.
std::uint16_t as_16_bits(double share);

// Returns the field's lowest and highest ground; for level ground the range is a metre high.
HeightRange range_of(const HeightField& field);

// Returns one number for each height: 0 at range.low, 65535 at range.high.
std::vector<std::uint16_t> height_texels(const HeightField& field, const HeightRange& range);

// Returns four numbers for each texel, the angles of the directions from `first` on: 65535 is a quarter turn.
std::vector<std::uint16_t> angle_texels(const HorizonAngles& angles, int first);

}  // namespace penumbra::bake
