// Visibility through a layer of clouds, without a map. Measurements compare a map of the clouds with it.
#pragma once

#include "parameters/cascades.h"
#include "reference/visibility_image.h"
#include "scene/frame.h"
#include "scene/scene.h"

namespace penumbra::reference {

// Multiplies each pixel's visibility by the mean, over the sun's disc, of the transmittance of the scene's
// clouds towards each of its points: the transmittance straight up, to the power of the way's length over the
// height (Beer and Lambert). That mean includes the disc's points that geometry hides: clouds are taken to be
// the same behind what is hidden. Nothing changes without clouds, or for receivers above them.
void shade_by_clouds(VisibilityImage& image, const scene::Scene& scene, const scene::Receivers& receivers,
                     const parameters::Light& light);

}  // namespace penumbra::reference
