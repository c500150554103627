// From light to what a screen shows.
//
// Source: Khronos PBR Neutral tone mapper (Khronos Group, 2024): colours up to 0.8 keep hue and contrast,
// less the 4 % that every surface mirrors; brighter ones are compressed towards white, and desaturate on the
// way. Chosen because the step from lit to shadowed stays the one that was computed.
#pragma once

#include <glm/vec3.hpp>

namespace penumbra::lighting {

// Linear Rec. 709, 1 = what the exposure maps to white, to linear in [0, 1]. Infinite light is white, NaN and
// negative light black.
glm::vec3 tone_mapped(const glm::vec3& colour);

// Linear [0, 1] to sRGB's encoding (IEC 61966-2-1), and back.
float srgb_encoded(float linear);
float srgb_decoded(float encoded);

}  // namespace penumbra::lighting
