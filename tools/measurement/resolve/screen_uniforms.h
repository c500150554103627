// What every pass over the screen is told of the camera and of its textures. Internal to this folder.
#pragma once

#include "gpu/resources.h"
#include "resolve/camera_image.h"
#include "resolve/uniform_values.h"

namespace penumbra::resolve {

// Width, height and their inverses, as _PenumbraTargetSize and its like hold them.
glm::vec4 texture_size(int width, int height);
glm::vec4 texture_size(const gpu::Image& image);

// Without a second eye both are the first.
void set_screen(UniformValues& values, const CameraImage& camera, const CameraImage* second_eye = nullptr);

}  // namespace penumbra::resolve
