// T2: what a shadow map says about a disc light, by one defined estimate. A reference, not a bound.
//
// Estimate: each texel of the receiver's cascade tile is a square, perpendicular to the light, at its stored
// depth. Seen from the receiver p, a square at gap g (metres from p towards the light) covers the points s of
// the unit disc for which p + g (L + tan(a/2) s) lies in it: a rectangle in s, since s's axes are the map's.
//
//        light's disc  ____[####]______      visibility = 1 - share of the disc that
//                           \  /             the union of all rectangles covers
//        texel at its depth  --   .
//                            | g            (layers that overlap count once)
//        receiver            p
//
// A texel blocks when its depth at its centre is above the receiver's plane and above the receiver itself,
// each by more than one quantum of the map's format (d16 1/65535, d24 1/(2^24 - 1), d32 2^-24, the spacing of
// floats in [1/2, 1)); the plane goes through p with the geometric normal. Texels holding the cleared depth,
// NaN, infinities or anything outside [0, 1] do not block. Beyond its tile the map knows no blocker. p is
// lifted off its surface as in the ray-traced reference (surface_offset). At angular diameter 0 the texel
// over p decides.
//
// Cascade: the first whose split sphere holds the position, as URP selects; with one cascade that one. Where
// no sphere holds it there is no map and visibility is 1.
//
// The disc is resolved by 1024 points (reference/disc_coverage.h states the error); noise_floor is measured
// over its halves as for any reference. Based on back-projection (Guennebaud et al., "Real-time soft shadow
// mapping by backprojection", 2006) with the union after Schwarz & Stamminger (2007). The same bytes come out
// whatever the number of threads.
#pragma once

#include <glm/vec3.hpp>

#include "parameters/cascades.h"
#include "reference/reference_cache.h"
#include "reference/row_blocks.h"
#include "reference/visibility_image.h"
#include "scene/frame.h"

namespace penumbra::reference {

// A map and the receivers that read it. `origin` is the world position that Receivers::position_relative is
// relative to.
struct MapView {
  const scene::ShadowAtlas& atlas;
  const parameters::CascadeSet& cascades;
  const scene::Receivers& receivers;
  glm::dvec3 origin{0.0};
};

// Throws InputError when sizes disagree or the matrices are unusable; platform::Interrupted when cancelled.
VisibilityImage same_map_estimate(const MapView& view, const RunOptions& run = {},
                                  const ReferenceCache* cache = nullptr);

// Returns the cascade that a world position reads from, or -1.
int select_cascade(const parameters::CascadeSet& cascades, const glm::dvec3& position_ws);

}  // namespace penumbra::reference
