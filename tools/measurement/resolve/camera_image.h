// The camera as passes over the screen see it: its depth texture and the matrix back to the world.
//
// It is made from a frame's receivers: the depth of a pixel is where the ray through its centre meets the
// plane of the surface seen there, rounded to a float once, as a depth buffer of 32 bits holds it. Pixels
// without a receiver hold the far plane's depth.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <vector>

#include "gpu/resources.h"
#include "resolve/uniform_values.h"
#include "scene/frame.h"

namespace penumbra::resolve {

// The place of row 0 in the screen's textures: Direct3D, Metal and Vulkan keep the top of the picture there,
// OpenGL its bottom.
enum class RowOrder { top_first, bottom_first };

struct CameraImage {
  int width = 0;
  int height = 0;
  RowOrder rows = RowOrder::top_first;
  std::vector<float> depth;         // stored: 1 at the near plane when reversed, else 0
  glm::dmat4 screen_to_world{1.0};  // (uv, stored depth, 1) to homogeneous world metres
};

// The depth runs in the same direction as the frame's shadow map: Unity has one direction for both.
CameraImage camera_image(const scene::Frame& frame, RowOrder rows = RowOrder::top_first);

// Returns the rows in the order of the frame's receivers, whichever order they came in.
template <typename T>
std::vector<T> rows_from_top(const std::vector<T>& image, int width, RowOrder rows) {
  if (rows == RowOrder::top_first) return image;
  std::vector<T> turned;
  turned.reserve(image.size());
  for (auto row = image.end(); row != image.begin();) {
    row -= width;
    turned.insert(turned.end(), row, row + width);
  }
  return turned;
}

// Returns width, height and their inverses, as _PenumbraTargetSize and similar uniforms hold them.
glm::vec4 texture_size(int width, int height);
glm::vec4 texture_size(const gpu::Image& image);

// Without a second eye, the first eye stands for both.
void set_screen(UniformValues& values, const CameraImage& camera, const CameraImage* second_eye = nullptr);

// Sets the matrices from the screen to that of the frame before, for each eye.
void set_previous_screen(UniformValues& values, std::array<const CameraImage*, 2> eyes,
                         std::array<const CameraImage*, 2> before);

}  // namespace penumbra::resolve
