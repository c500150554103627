// The place of a camera from which a model and its shadow fill the picture.
#pragma once

#include <glm/vec3.hpp>

#include "parameters/cascades.h"

namespace penumbra::scene {

// The camera looks down at the box by 25 degrees, from in front of it and a little to the side, with the
// default lens. It is as near as possible while the box and its shadow on the plane through its bottom lie
// within the middle 92 % of a 16:9 picture, so that as many pixels as possible are penumbra. The near plane
// is in front of all that. light_direction is the direction in which the light travels, downwards.
parameters::Camera framing_camera(const parameters::Bounds& box, const glm::dvec3& light_direction);

// Returns the distance to the farthest point of the box or its shadow, in metres.
double framed_reach(const parameters::Camera& camera, const parameters::Bounds& box,
                    const glm::dvec3& light_direction);

}  // namespace penumbra::scene
