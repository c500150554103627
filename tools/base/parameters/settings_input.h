// A --config file: {camera: {...}, light: {...}, shadows: {...}}, every key optional, URP's defaults where
// URP has one. Lengths in metres, angles in degrees.
//
//   camera   position, forward, up, fov_y_degrees, aspect, near, far
//   light    direction (the way the light travels), angular_diameter_degrees
//   shadows  distance_metres, cascades, splits, resolution, depth_bias, normal_bias,
//            soft_quality ("off", "low", "medium", "high"), reversed_z,
//            depth_range_metres | caster_bounds {min, max}, fit_to_bounds, near_plane_offset_metres,
//            clip_depth ("zero_to_one", "minus_one_to_one")
#pragma once

#include "parameters/cascades.h"

namespace penumbra {
class LocatedJson;
class JsonObject;
}  // namespace penumbra

namespace penumbra::parameters {

struct FitInput {
  Camera camera;
  Light light;
  ShadowSettings shadows;
};

// Throws InputError at file:line:column for wrong types, unknown keys and values out of range.
FitInput read_settings(const LocatedJson& document);

// Names are those of files and flags; for others these throw InputError naming the nearest.
SoftQuality soft_quality_named(const std::string& name);
ClipDepth clip_depth_named(const std::string& name);
const char* name_of(SoftQuality quality);
const char* name_of(ClipDepth convention);

// These read the same for one key of an object, at its place in the file.
SoftQuality read_soft_quality(JsonObject& object, const std::string& key, SoftQuality fallback);
ClipDepth read_clip_depth(JsonObject& object, const std::string& key, ClipDepth fallback);

}  // namespace penumbra::parameters
