#include "resolve/camera_image.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "parameters/half_angle.h"

namespace penumbra::resolve {
namespace {

// A point of the picture, uv in [0, 1] from its first row, lies along origin + u * across + v * down from the
// eye, at view depth 1.
struct Lens {
  glm::dvec3 origin;
  glm::dvec3 across;
  glm::dvec3 down_the_rows;
};

// The stored depth is a function of the view depth z: scale / z + offset.
struct StoredDepth {
  double scale;
  double offset;
};

// Unity's world is left-handed: right = up x forward.
Lens lens_of(const scene::Frame& frame, RowOrder rows) {
  const parameters::Camera& camera = frame.camera;
  const glm::dvec3 forward = glm::normalize(camera.forward);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, forward));
  const glm::dvec3 up = glm::cross(forward, right);
  const double tan_y = parameters::tan_half(camera.fov_y_degrees);
  const glm::dvec3 half_width = right * (tan_y * camera.aspect);
  const glm::dvec3 half_height = up * tan_y;
  const glm::dvec3 centre =
      forward + half_width * frame.settings.lens_shift.x + half_height * frame.settings.lens_shift.y;
  const glm::dvec3 first_row = rows == RowOrder::top_first ? half_height : -half_height;
  return {centre - half_width + first_row, half_width * 2.0, first_row * -2.0};
}

StoredDepth stored_depth_of(const parameters::Camera& camera, bool reversed_z) {
  const double near = camera.near_plane;
  const double far = camera.far_plane;
  if (reversed_z) return {near * far / (far - near), -near / (far - near)};
  return {-near * far / (far - near), far / (far - near)};
}

// With q = (depth - offset) / scale = 1 / z, the point eye + z * direction(uv) is (eye * q + direction, q).
glm::dmat4 screen_to_world(const Lens& lens, const StoredDepth& stored, const glm::dvec3& eye) {
  glm::dmat4 matrix(0.0);
  matrix[0] = glm::dvec4(lens.across, 0.0);
  matrix[1] = glm::dvec4(lens.down_the_rows, 0.0);
  matrix[2] = glm::dvec4(eye, 1.0) / stored.scale;
  matrix[3] = glm::dvec4(lens.origin, 0.0) - glm::dvec4(eye, 1.0) * (stored.offset / stored.scale);
  return matrix;
}

// Returns the view depth at which the ray through a pixel's centre meets the receiver's plane. `direction`
// ends at view depth 1.
double depth_on_plane(const glm::dvec3& from_eye, const glm::dvec3& normal, const glm::dvec3& direction) {
  return glm::dot(normal, from_eye) / glm::dot(normal, direction);
}

}  // namespace

CameraImage camera_image(const scene::Frame& frame, RowOrder rows) {
  const bool reversed_z = frame.cascades.reversed_z;
  const scene::Receivers& seen = frame.receivers;
  const Lens lens = lens_of(frame, rows);
  const StoredDepth stored = stored_depth_of(frame.camera, reversed_z);
  CameraImage image{seen.width, seen.height, rows, {}, screen_to_world(lens, stored, frame.camera.position)};
  for (int row = 0; row < seen.height; ++row) {
    const int seen_row = rows == RowOrder::top_first ? row : seen.height - 1 - row;
    for (int column = 0; column < seen.width; ++column) {
      const auto pixel = static_cast<std::size_t>(seen_row) * static_cast<std::size_t>(seen.width) +
                         static_cast<std::size_t>(column);
      if (seen.position_ws[pixel].w == 0.0f) {
        image.depth.push_back(reversed_z ? 0.0f : 1.0f);
        continue;
      }
      const glm::dvec3 direction = lens.origin + lens.across * ((column + 0.5) / seen.width) +
                                   lens.down_the_rows * ((row + 0.5) / seen.height);
      const glm::dvec3 from_eye = glm::dvec3(seen.position_ws[pixel]) - frame.camera.position;
      const double z = depth_on_plane(from_eye, glm::dvec3(seen.normal_ws[pixel]), direction);
      image.depth.push_back(static_cast<float>(stored.scale / z + stored.offset));
    }
  }
  return image;
}

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

void set_previous_screen(UniformValues& values, std::array<const CameraImage*, 2> eyes,
                         std::array<const CameraImage*, 2> before) {
  std::array<glm::dmat4, 2> to_previous{};
  for (std::size_t eye = 0; eye < eyes.size(); ++eye)
    to_previous[eye] = glm::inverse(before[eye]->screen_to_world) * eyes[eye]->screen_to_world;
  values.set("_PenumbraToPreviousScreen", std::span<const glm::dmat4>(to_previous));
}

}  // namespace penumbra::resolve
