#include "resolve/screen_uniforms.h"

#include <array>

namespace penumbra::resolve {

glm::vec4 texture_size(int width, int height) {
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  return {w, h, 1.0f / w, 1.0f / h};
}

glm::vec4 texture_size(const gpu::Image& image) {
  return texture_size(image.width(), image.height());
}

void set_screen(UniformValues& values, const CameraImage& camera, const CameraImage* second_eye) {
  const std::array<glm::dmat4, 2> eyes{
      camera.screen_to_world, second_eye == nullptr ? camera.screen_to_world : second_eye->screen_to_world};
  values.set("_PenumbraScreenToWorld", std::span<const glm::dmat4>(eyes));
  values.set("_PenumbraScreenSize", texture_size(camera.width, camera.height));
}

}  // namespace penumbra::resolve
