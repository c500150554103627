// The reference at edges of a multisampled picture: the mean of the visibility at a pixel's samples.
//
// A pixel counts if its samples see several surfaces: two of them face different ways, or lie apart. Pixels
// one of whose samples sees no receiver do not count: the sky beside them has no shadow to compare. Internal
// to this folder.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "parameters/cascades.h"
#include "reference/visibility_image.h"
#include "scene/frame.h"

namespace penumbra::study {

// Returns the places of a pixel's samples, from its centre, in pixels to the right and down: the standard
// patterns of Direct3D and Vulkan. `samples` is 2, 4 or 8; throws std::invalid_argument for others.
std::vector<glm::dvec2> sample_offsets(int samples);

// The receivers that all pixels' samples of one number see, and their reference.
struct SampleView {
  scene::Receivers receivers;
  reference::VisibilityImage traced;
};

// `samples` are of equal size, at least 2. The result's visibility is the mean; it is valid at edges alone.
reference::VisibilityImage edge_reference(std::span<const SampleView> samples,
                                          const parameters::Camera& camera);

}  // namespace penumbra::study
