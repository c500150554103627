// The uniforms that describe the camera and its textures to every pass over the screen. Internal to this
// folder.
#pragma once

#include "gpu/resources.h"
#include "resolve/camera_image.h"
#include "resolve/uniform_values.h"

namespace penumbra::resolve {

// Returns width, height and their inverses, as _PenumbraTargetSize and similar uniforms hold them.
glm::vec4 texture_size(int width, int height);
glm::vec4 texture_size(const gpu::Image& image);

// Without a second eye, the first eye stands for both.
void set_screen(UniformValues& values, const CameraImage& camera, const CameraImage* second_eye = nullptr);

}  // namespace penumbra::resolve
