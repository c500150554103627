// From light to what a screen shows.
//
// Source: H. Uchimura, "HDR Theory and Practice" (CEDEC 2017), per channel, with the paper's parameters
// P = 1, a = 1, m = 0.22, l = 0.4, c = 1.33, b = 0: a toe that deepens what is dark, as film does, then light
// as it is from 0.22 to 0.532, then an exponential shoulder that ends at white.
#pragma once

#include <glm/vec3.hpp>

namespace penumbra::lighting {

// Linear Rec. 709, exposed, to linear in [0, 1]. Infinite light is white, NaN and negative light black.
glm::vec3 tone_mapped(const glm::vec3& colour);

// Linear [0, 1] to sRGB's encoding (IEC 61966-2-1), and back.
float srgb_encoded(float linear);
float srgb_decoded(float encoded);

}  // namespace penumbra::lighting
