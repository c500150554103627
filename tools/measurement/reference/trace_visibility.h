// T1: the visibility of a disc light, the sun, ray-traced on the real geometry.
//
// Computes, for each receiver, the share of the light's disc that no triangle hides. Embree 3 (robust
// intersection) traces a low-discrepancy set of points of the disc, uniform by area on the disc perpendicular
// to the light; reference/lit_receiver.h has the formula, the ray offset, and the rule for receivers.
// Cut-outs let rays pass where they are open (reference/embree_scene.h). Spaces: receivers and mesh are
// relative to the scene's origin, in metres; the scene's place in the world does not enter.
// Receivers::position_relative is used, position_ws only for its w. Guarantees: the result is unbiased up to
// the ray offset; the same seed gives the same bytes on one machine, whatever the number of threads;
// visibility is in [0, 1]; the image states its own noise floor.
#pragma once

#include <cstdint>

#include "parameters/cascades.h"
#include "reference/reference_cache.h"
#include "reference/row_blocks.h"
#include "reference/visibility_image.h"
#include "scene/frame.h"
#include "scene/scene.h"

namespace penumbra::reference {

// The number of rays per pixel is a power of two within these bounds.
inline constexpr int fewest_samples = 32;
inline constexpr int most_samples = 65536;

void check_samples(int samples);  // throws InputError for another number

struct TraceOptions {
  int samples = 1024;  // rays per pixel
  std::uint64_t seed = 1;
};

// A point light needs one ray per pixel. Throws InputError if options, light, mesh or receivers are unusable,
// and platform::Interrupted when cancelled.
VisibilityImage trace_visibility(const scene::Scene& scene, const scene::Receivers& receivers,
                                 const parameters::Light& light, const TraceOptions& options = {},
                                 const RunOptions& run = {}, const ReferenceCache* cache = nullptr);

// Multiplies each pixel's visibility by the mean, over the sun's disc, of the transmittance of the scene's
// clouds towards each of its points: the transmittance straight up, to the power of the way's length over the
// height (Beer and Lambert). That mean includes the disc's points that geometry hides: clouds are taken to be
// the same behind what is hidden. Nothing changes without clouds, or for receivers above them.
void shade_by_clouds(VisibilityImage& image, const scene::Scene& scene, const scene::Receivers& receivers,
                     const parameters::Light& light);

}  // namespace penumbra::reference
