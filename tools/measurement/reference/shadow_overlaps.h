// The receivers on which shadows of low and of high casters lie over each other.
//
// There a shadow map holds the high caster alone, and the mean distance of both is that of neither. Computed
// by rays to points of the light's disc on the real geometry: the gap of the lowest caster on each ray, and
// that of the highest. Reentrant; the same input gives the same result with any number of threads.
#pragma once

#include <cstdint>
#include <vector>

#include "parameters/cascades.h"
#include "reference/visibility_image.h"
#include "scene/frame.h"
#include "scene/scene.h"

namespace penumbra::reference {

// The gaps of two casters over one receiver overlap from this ratio on: penumbrae then differ as much in
// width.
inline constexpr double kOverlapRatio = 4.0;

// Returns 1 for every receiver that does not see the whole disc, by `visibility`, and over which the highest
// caster is kOverlapRatio times as far away as the lowest. `jobs`: threads, 0 for one per core.
std::vector<std::uint8_t> shadow_overlaps(const scene::Scene& scene, const scene::Receivers& receivers,
                                          const parameters::Light& light, const VisibilityImage& visibility,
                                          int jobs = 0);

}  // namespace penumbra::reference
