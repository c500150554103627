// Bakes as texels of 16 bits, as files and textures hold them: 8 bits are steps of 0.35 degrees of a quarter
// turn, wider than the sun.
//
// Rows run from the smallest z, as in Unity's textures; the first texel is that of the smallest x.
#pragma once

#include <cstdint>
#include <vector>

#include "bake/height_field.h"
#include "bake/height_source.h"
#include "bake/horizon_angles.h"

namespace penumbra::bake {

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
