#include "scene/framing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <vector>

#include "parameters/half_angle.h"
#include "scene/scene.h"

namespace penumbra::scene {
namespace {

constexpr double kShareOfPicture = 0.92;
constexpr double kElevationDegrees = 25.0;
constexpr double kLowestSunSlope = 0.25;  // a lower sun's shadow is too long to frame whole

std::vector<glm::dvec3> corners(const parameters::Bounds& box) {
  std::vector<glm::dvec3> points;
  for (const double x : {box.minimum.x, box.maximum.x}) {
    for (const double y : {box.minimum.y, box.maximum.y}) {
      for (const double z : {box.minimum.z, box.maximum.z}) points.emplace_back(x, y, z);
    }
  }
  return points;
}

std::vector<glm::dvec3> with_shadow(const parameters::Bounds& box, const glm::dvec3& light_direction) {
  std::vector<glm::dvec3> points = corners(box);
  const glm::dvec3 light = glm::normalize(light_direction);
  const double fall = std::max(-light.y, kLowestSunSlope);
  for (const glm::dvec3& corner : corners(box)) {
    const double height = corner.y - box.minimum.y;
    points.emplace_back(corner.x + light.x / fall * height, box.minimum.y,
                        corner.z + light.z / fall * height);
  }
  return points;
}

glm::dvec3 middle(const std::vector<glm::dvec3>& points) {
  glm::dvec3 low = points.front();
  glm::dvec3 high = points.front();
  for (const glm::dvec3& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return 0.5 * (low + high);
}

// Returns the largest picture coordinate of any point, 1 at the picture's edge; infinite if a point is not in
// front.
double extent(const parameters::Camera& camera, const std::vector<glm::dvec3>& points) {
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, camera.forward));
  const glm::dvec3 up = glm::cross(camera.forward, right);
  const double tan_half = parameters::tan_half(camera.fov_y_degrees);
  double largest = 0.0;
  for (const glm::dvec3& point : points) {
    const glm::dvec3 to = point - camera.position;
    const double depth = glm::dot(to, camera.forward);
    if (depth <= 1e-9) return std::numeric_limits<double>::infinity();
    largest = std::max({largest, std::abs(glm::dot(to, up)) / (depth * tan_half),
                        std::abs(glm::dot(to, right)) / (depth * tan_half * camera.aspect)});
  }
  return largest;
}

}  // namespace

parameters::Camera framing_camera(const parameters::Bounds& box, const glm::dvec3& light_direction) {
  const std::vector<glm::dvec3> points = with_shadow(box, light_direction);
  const glm::dvec3 target = middle(points);
  const double elevation = glm::radians(kElevationDegrees);
  const glm::dvec3 level = glm::normalize(glm::dvec3(0.35, 0.0, -0.94));
  const glm::dvec3 towards_camera = std::cos(elevation) * level + glm::dvec3(0.0, std::sin(elevation), 0.0);
  const double size = glm::distance(box.minimum, box.maximum);
  double near = 0.0;
  double far = 100.0 * size;
  for (int i = 0; i < 60; ++i) {
    const double distance = 0.5 * (near + far);
    const bool fits =
        extent(camera_looking(target + distance * towards_camera, target), points) <= kShareOfPicture;
    (fits ? far : near) = distance;
  }
  parameters::Camera camera = camera_looking(target + far * towards_camera, target);
  double nearest = far;
  for (const glm::dvec3& point : points) {
    nearest = std::min(nearest, glm::dot(point - camera.position, camera.forward));
  }
  camera.near_plane = std::min(camera.near_plane, 0.5 * nearest);
  return camera;
}

double framed_reach(const parameters::Camera& camera, const parameters::Bounds& box,
                    const glm::dvec3& light_direction) {
  double reach = 0.0;
  for (const glm::dvec3& point : with_shadow(box, light_direction)) {
    reach = std::max(reach, glm::distance(point, camera.position));
  }
  return reach;
}

}  // namespace penumbra::scene
