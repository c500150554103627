// T1: the visibility of a disc light, the sun or a spot light, ray-traced on the real geometry.
//
// What: for each receiver, the share of the light's disc that no triangle hides, by Embree 3 (robust
// intersection) over a low-discrepancy set of points of the disc, uniform by area on the disc perpendicular
// to the light (reference/lit_receiver.h has the formula, the ray offset, and who is a receiver). Cut-outs
// let rays pass where they are open (reference/embree_scene.h). Spaces: receivers and mesh relative to the
// scene's origin, metres; the scene's place in the world does not enter. Receivers::position_relative is
// used, position_ws only for its w. Guarantees: unbiased up to the ray offset; the same seed gives the same
// bytes on one machine, whatever the number of threads; visibility in [0, 1]; the image states its own noise
// floor.
#pragma once

#include <cstdint>

#include "parameters/cascades.h"
#include "parameters/spot_light.h"
#include "reference/reference_cache.h"
#include "reference/row_blocks.h"
#include "reference/visibility_image.h"
#include "scene/frame.h"
#include "scene/scene.h"

namespace penumbra::reference {

// Rays per pixel are a power of two within these.
inline constexpr int fewest_samples = 32;
inline constexpr int most_samples = 65536;

void check_samples(int samples);  // throws InputError for another number

struct TraceOptions {
  int samples = 1024;  // rays per pixel
  std::uint64_t seed = 1;
};

// To a point light one ray per pixel decides. Throws InputError: options, light, mesh or receivers
// unusable; platform::Interrupted when cancelled.
VisibilityImage trace_visibility(const scene::Scene& scene, const scene::Receivers& receivers,
                                 const parameters::Light& light, const TraceOptions& options = {},
                                 const RunOptions& run = {}, const ReferenceCache* cache = nullptr);

// The same of a spot light, its position relative to the scene's origin. Receivers outside of its cone or
// beyond its range are not valid; the cone's falloff is no part of visibility.
VisibilityImage trace_visibility(const scene::Scene& scene, const scene::Receivers& receivers,
                                 const parameters::SpotLight& light, const TraceOptions& options = {},
                                 const RunOptions& run = {}, const ReferenceCache* cache = nullptr);

}  // namespace penumbra::reference
