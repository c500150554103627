#include "lighting/hand_made.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

namespace penumbra::lighting::hand_made {
namespace {

double distance_to(const scene::Mesh& mesh, std::size_t triangle, const glm::dvec3& eye,
                   const glm::dvec3& direction) {
  const auto corner = [&](std::size_t k) {
    return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + k]]);
  };
  const glm::dvec3 ab = corner(1) - corner(0);
  const glm::dvec3 ac = corner(2) - corner(0);
  const glm::dvec3 across = glm::cross(direction, ac);
  const glm::dvec3 to_eye = eye - corner(0);
  const double determinant = glm::dot(ab, across);
  const double b = glm::dot(to_eye, across) / determinant;
  const double c = glm::dot(direction, glm::cross(to_eye, ab)) / determinant;
  const double distance = glm::dot(ac, glm::cross(to_eye, ab)) / determinant;
  const bool inside = b >= 0.0 && c >= 0.0 && b + c <= 1.0 && distance > 0.0;
  return inside ? distance : HUGE_VAL;
}

}  // namespace

void add_square(scene::Scene& scene, const glm::dvec3& centre, const glm::dvec3& right, const glm::dvec3& up,
                std::uint16_t material) {
  scene::Mesh& mesh = scene.mesh;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const glm::vec3 normal(glm::normalize(glm::cross(up, right)));  // left-handed, as Unity's space is
  for (const glm::dvec2 corner :
       {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
    mesh.positions.emplace_back(centre + right * corner.x + up * corner.y);
    mesh.normals.push_back(normal);
    mesh.uvs.emplace_back(corner.x * 0.5 + 0.5, 0.5 - corner.y * 0.5);  // v falls along up
  }
  for (const std::uint32_t k : {0U, 2U, 1U, 0U, 3U, 2U}) mesh.indices.push_back(first + k);
  mesh.triangle_materials.insert(mesh.triangle_materials.end(), 2, material);
}

scene::Scene looking_down(double height, const glm::dvec3& to_sun) {
  scene::Scene scene;
  scene.name = "hand-made";
  scene.camera.position = {0.0, height, 0.0};
  scene.camera.forward = {0.0, -1.0, 0.0};
  scene.camera.up = {0.0, 0.0, 1.0};
  scene.camera.fov_y_degrees = 60.0;
  scene.camera.aspect = 1.0;
  scene.light_direction = -to_sun;
  return scene;
}

glm::dvec3 pixel_direction(const scene::Scene& scene, const scene::FrameSettings& settings, int column,
                           int row) {
  const parameters::Camera& camera = scene.camera;
  const glm::dvec3 forward = glm::normalize(camera.forward);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, forward));
  const double tan_half = std::tan(glm::radians(camera.fov_y_degrees) / 2.0);
  const double x = ((column + 0.5) / settings.width * 2.0 - 1.0) * tan_half * camera.aspect;
  const double y = (1.0 - (row + 0.5) / settings.height * 2.0) * tan_half;
  return glm::normalize(forward + right * x + glm::cross(forward, right) * y);
}

scene::Frame frame_of(const scene::Scene& scene, int width, int height) {
  scene::Frame frame;
  frame.scene_name = scene.name;
  frame.camera = scene.camera;
  frame.settings.width = width;
  frame.settings.height = height;
  frame.settings.angular_diameter_degrees = 0.5;
  scene::Receivers& seen = frame.receivers;
  seen.width = width;
  seen.height = height;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const glm::dvec3 direction = pixel_direction(scene, frame.settings, column, row);
      double nearest = HUGE_VAL;
      std::uint32_t triangle = scene::no_triangle;
      for (std::size_t i = 0; i < scene.mesh.triangle_count(); ++i) {
        const double distance = distance_to(scene.mesh, i, scene.camera.position, direction);
        if (distance >= nearest) continue;
        nearest = distance;
        triangle = static_cast<std::uint32_t>(i);
      }
      const bool hit = triangle != scene::no_triangle;
      const glm::vec3 position(hit ? scene.camera.position + direction * nearest : glm::dvec3(0.0));
      seen.triangle.push_back(triangle);
      seen.position_relative.emplace_back(position, hit ? 1.0F : 0.0F);
      seen.position_ws.emplace_back(position, hit ? 1.0F : 0.0F);
      seen.normal_ws.emplace_back(0.0F);
    }
  }
  return frame;
}

}  // namespace penumbra::lighting::hand_made
