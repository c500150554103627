// A tone curve: it maps light to the values that a screen shows.
//
// Source: H. Uchimura, "HDR Theory and Practice" (CEDEC 2017), per channel, with the paper's parameters P =
// 1, a = 1, m = 0.22, l = 0.4, c = 1.33, b = 0. Its toe deepens what is dark, as film does; from 0.22 to
// 0.532 light stays as it is; then an exponential shoulder ends at white.
#pragma once

#include <glm/vec3.hpp>

namespace penumbra::lighting {

// Maps exposed linear Rec. 709 to linear values in [0, 1]. Infinite light is white; NaN and negative light
// are black.
glm::vec3 tone_mapped(const glm::vec3& colour);

// These convert linear values in [0, 1] to sRGB's encoding (IEC 61966-2-1), and back.
float srgb_encoded(float linear);
float srgb_decoded(float encoded);

}  // namespace penumbra::lighting
