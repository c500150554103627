// Scenes of a few triangles and the frames a rasteriser would make of them, without a device.
#pragma once

#include "scene/frame.h"
#include "scene/scene.h"

namespace penumbra::lighting::hand_made {

// Adds a square of side 2 * half_extent about a point, its corners counter-clockwise seen against the normal.
void add_square(scene::Scene& scene, const glm::dvec3& centre, const glm::dvec3& right, const glm::dvec3& up,
                std::uint16_t material = 0);

// A scene whose camera looks straight down at the origin from a height, +Z up in the picture, with the sun
// from `to_sun`.
scene::Scene looking_down(double height, const glm::dvec3& to_sun);

// The frame that a rasteriser makes of the scene, by trying every triangle at every pixel.
scene::Frame frame_of(const scene::Scene& scene, int width, int height);

// The direction through a pixel's centre, computed apart from the library.
glm::dvec3 pixel_direction(const scene::Scene& scene, const scene::FrameSettings& settings, int column,
                           int row);

}  // namespace penumbra::lighting::hand_made
