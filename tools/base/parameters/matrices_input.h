// Matrices dumped from Unity, whose own fit is native code: constants from these are Unity's own, to the bit
// of what was dumped.
//
//   {"matrix_order": "row-major" | "column-major",            of every matrix below; stated and checked
//    "clip_depth": "minus_one_to_one" | "zero_to_one",        of the projections; stated and checked
//    "reversed_z": true | false,                              of the device (SystemInfo.usesReversedZBuffer)
//    "angular_diameter_degrees": 0.53, "resolution": 2048,    the map's width in texels
//    "depth_bias": 1, "normal_bias": 1, "soft_quality": "medium",
//    "light_direction": [x, y, z],                            optional: the way the light travels; checked
//    "cascades": [{"view": [16], "projection": [16],          as ComputeDirectionalShadowMatrices gives them
//                  "world_to_shadow": [16],                   as in _MainLightWorldToShadow
//                  "split_sphere": [x, y, z, radius]}]}       optional
//
// A cascade gives view and projection, or world_to_shadow, or all three; all three must agree. Unity's own
// projections are -1 .. 1 and not reversed. A matrix that is not an orthographic light projection
// (perspective, singular, sheared, stretched, not finite) is refused with the reason and its place.
#pragma once

#include "parameters/cascades.h"

namespace penumbra {
class LocatedJson;
}

namespace penumbra::parameters {

struct MatricesDump {
  CascadeSet set;
  ShadowSettings settings;  // resolution, biases and quality; the rest is unused
};

MatricesDump read_matrices(const LocatedJson& document);

// Returns the shadow matrix as URP's GetShadowTransform and ApplySliceTransform build it.
glm::dmat4 shadow_transform(const glm::dmat4& view, const glm::dmat4& projection, ClipDepth clip_depth,
                            bool reversed_z, const glm::dvec4& offset_scale);

}  // namespace penumbra::parameters
