// Visibility through a layer of clouds, without a map: what a map of it is measured against.
#pragma once

#include "parameters/cascades.h"
#include "reference/visibility_image.h"
#include "scene/frame.h"
#include "scene/scene.h"

namespace penumbra::reference {

// Multiplies each pixel's visibility by the mean, over the sun's disc, of what the scene's clouds let pass
// along the way to each of its points: the transmittance straight up, to the power of the way's length over
// the height (Beer and Lambert). The disc's points that geometry hides are not left out of that mean: clouds
// are taken to be the same behind what is hidden. Nothing without clouds, and over them.
void shade_by_clouds(VisibilityImage& image, const scene::Scene& scene, const scene::Receivers& receivers,
                     const parameters::Light& light);

}  // namespace penumbra::reference
