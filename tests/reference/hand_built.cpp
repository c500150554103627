#include "reference/hand_built.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace penumbra::reference::hand_built {
namespace {

constexpr double depth_range = 40.0;
constexpr double farthest_gap = -10.0;

void add_triangle(scene::Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::vec3 normal(glm::normalize(glm::cross(b - a, c - a)));
  for (const glm::dvec3& corner : {a, b, c}) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.emplace_back(corner);
    mesh.normals.push_back(normal);
  }
}

void set_row(glm::dmat4& matrix, int row, const glm::dvec3& direction, double offset) {
  for (int column = 0; column < 3; ++column) matrix[column][row] = direction[column];
  matrix[3][row] = offset;
}

}  // namespace

glm::dvec3 Setting::at(double across, double along, double towards) const {
  const DiscLight frame = disc();
  return centre + across * frame.right + along * frame.up + towards * frame.to_light;
}

void add_rectangle(scene::Mesh& mesh, const Setting& setting, const Rectangle& rectangle, double towards) {
  const glm::dvec3 a = setting.at(rectangle.left, rectangle.bottom, towards);
  const glm::dvec3 b = setting.at(rectangle.right, rectangle.bottom, towards);
  const glm::dvec3 c = setting.at(rectangle.right, rectangle.top, towards);
  const glm::dvec3 d = setting.at(rectangle.left, rectangle.top, towards);
  add_triangle(mesh, a, b, c);
  add_triangle(mesh, a, c, d);
}

void add_circle(scene::Mesh& mesh, const Setting& setting, double radius, double towards) {
  constexpr int corners = 720;
  const auto corner = [&](int index) {
    const double angle = 2.0 * std::numbers::pi * index / corners;
    return setting.at(radius * std::cos(angle), radius * std::sin(angle), towards);
  };
  for (int index = 0; index < corners; ++index) {
    add_triangle(mesh, setting.at(0.0, 0.0, towards), corner(index), corner(index + 1));
  }
}

scene::Receivers receivers(const Setting& setting, ImageSize size,
                           const std::function<glm::dvec2(int x, int y)>& place) {
  scene::Receivers result;
  result.width = size.width;
  result.height = size.height;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const glm::dvec2 across = place(x, y);
      const glm::vec4 position(glm::vec3(setting.at(across.x, across.y, 0.0)), 1.0F);
      result.position_relative.push_back(position);
      result.position_ws.push_back(position);
      result.normal_ws.emplace_back(glm::vec3(setting.disc().to_light), 0.0F);
    }
  }
  return result;
}

double mean(const VisibilityImage& image) {
  double sum = 0.0;
  for (const float visibility : image.visibility) sum += visibility;
  return sum / static_cast<double>(image.visibility.size());
}

double visible_past_edge(double distance, double gap, double tan_half) {
  const double chord = std::clamp(distance / (gap * tan_half), -1.0, 1.0);
  return 0.5 + (chord * std::sqrt(1.0 - chord * chord) + std::asin(chord)) / std::numbers::pi;
}

double Map::stored_depth(double gap_metres) const {
  const double nearness = (gap_metres - farthest_gap) / depth_range;
  return cascades.reversed_z ? nearness : 1.0 - nearness;
}

void Map::set_depth(int column, int row, float depth) {
  atlas.depth[static_cast<std::size_t>(row) * static_cast<std::size_t>(atlas.width) +
              static_cast<std::size_t>(column)] = depth;
}

void Map::set_gap(int column, int row, double gap_metres) {
  set_depth(column, row, static_cast<float>(stored_depth(gap_metres)));
}

Map empty_map(const Setting& setting, const MapSettings& settings, const glm::dvec3& origin) {
  const DiscLight frame = setting.disc();
  const glm::dvec3 centre = setting.centre + origin;
  Map map;
  map.cascades.reversed_z = settings.reversed_z;
  map.cascades.angular_diameter_degrees = setting.light.angular_diameter_degrees;
  map.cascades.light_direction = -frame.to_light;
  map.atlas.width = map.atlas.height = settings.resolution;
  map.atlas.format = settings.format;
  const auto side = static_cast<std::size_t>(settings.resolution);
  map.atlas.depth.assign(side * side, settings.reversed_z ? 0.0F : 1.0F);
  parameters::Cascade cascade;
  const double sign = settings.reversed_z ? 1.0 : -1.0;
  const glm::dvec3 across = frame.right / settings.extent;
  const glm::dvec3 along = frame.up / settings.extent;
  const glm::dvec3 depth = sign * frame.to_light / depth_range;
  set_row(cascade.world_to_shadow, 0, across, 0.5 - glm::dot(across, centre));
  set_row(cascade.world_to_shadow, 1, along, 0.5 - glm::dot(along, centre));
  set_row(cascade.world_to_shadow, 2, depth, map.stored_depth(0.0) - glm::dot(depth, centre));
  map.cascades.cascades.push_back(cascade);
  return map;
}

}  // namespace penumbra::reference::hand_built
