#include "reference/closest_surface.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace penumbra::reference {
namespace {

std::optional<double> height_below(const EmbreeScene& rays, double above, glm::vec2 xz) {
  const auto top = static_cast<float>(above);
  const std::optional<float> drop =
      rays.first_hit({xz.x, top, xz.y}, {0.0F, -1.0F, 0.0F}, std::numeric_limits<float>::infinity());
  if (!drop) return std::nullopt;
  return static_cast<double>(top) - static_cast<double>(*drop);
}

using Feature = TrianglePoint::Feature;

TrianglePoint on_segment(const glm::dvec3& place, const glm::dvec3& from, const glm::dvec3& to, int edge) {
  const glm::dvec3 along = to - from;
  const double squared = glm::dot(along, along);
  const double share = squared > 0.0 ? std::clamp(glm::dot(place - from, along) / squared, 0.0, 1.0) : 0.0;
  if (share == 0.0) return {from, Feature::corner, edge};
  if (share == 1.0) return {to, Feature::corner, (edge + 1) % 3};
  return {from + share * along, Feature::edge, edge};
}

glm::dvec3 unit_or_zero(const glm::dvec3& vector) {
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

double angle_at(const std::array<glm::dvec3, 3>& corners, std::size_t corner) {
  const glm::dvec3 first = unit_or_zero(corners[(corner + 1) % 3] - corners[corner]);
  const glm::dvec3 second = unit_or_zero(corners[(corner + 2) % 3] - corners[corner]);
  return std::acos(std::clamp(glm::dot(first, second), -1.0, 1.0));
}

}  // namespace

TrianglePoint nearest_on_triangle(const glm::dvec3& place, const std::array<glm::dvec3, 3>& corners) {
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double squared = glm::dot(normal, normal);
  bool inside = squared > 0.0;
  for (std::size_t i = 0; i < 3 && inside; ++i) {
    const glm::dvec3 edge = corners[(i + 1) % 3] - corners[i];
    inside = glm::dot(glm::cross(normal, edge), place - corners[i]) >= 0.0;
  }
  if (inside) return {place - normal * (glm::dot(place - corners[0], normal) / squared), Feature::face, 0};
  TrianglePoint nearest;
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const TrianglePoint found = on_segment(place, corners[static_cast<std::size_t>(i)],
                                           corners[static_cast<std::size_t>((i + 1) % 3)], i);
    const glm::dvec3 apart = place - found.point;
    if (glm::dot(apart, apart) >= best) continue;
    best = glm::dot(apart, apart);
    nearest = found;
  }
  return nearest;
}

ClosestSurface::ClosestSurface(const EmbreeScene& rays, const scene::Scene& scene)
    : rays_(rays), mesh_(scene.mesh) {
  std::map<std::tuple<float, float, float>, std::uint32_t> at_position;  // 0 and -0 are equal
  for (const std::uint32_t index : mesh_.indices) {
    const glm::vec3& position = mesh_.positions[index];
    vertices_.push_back(
        at_position
            .try_emplace({position.x, position.y, position.z}, static_cast<std::uint32_t>(at_position.size()))
            .first->second);
  }
  corner_normals_.resize(at_position.size());
  edge_normals_.resize(mesh_.indices.size());
  double volume = 0.0;  // six times the volume that the triangles enclose
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::map<Edge, std::vector<std::size_t>>
      passed;  // the corners from which triangles pass an edge, in its direction
  for (std::size_t triangle = 0; triangle < mesh_.triangle_count(); ++triangle) {
    const std::array<glm::dvec3, 3> at = corners(triangle);
    face_normals_.push_back(unit_or_zero(glm::cross(at[1] - at[0], at[2] - at[0])));
    volume += glm::dot(at[0], glm::cross(at[1], at[2]));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = vertices_[3 * triangle + i], to = vertices_[3 * triangle + (i + 1) % 3];
      corner_normals_[from] += angle_at(at, i) * face_normals_.back();
      if (from != to) passed[{from, to}].push_back(3 * triangle + i);
    }
  }
  for (const auto& [edge, ours] : passed) {
    const auto theirs = passed.find({edge.second, edge.first});
    const bool closed = ours.size() == 1 && theirs != passed.end() && theirs->second.size() == 1;
    if (!closed) ++open_edges_;
    glm::dvec3 sum(0.0);
    for (const std::size_t corner : ours) sum += face_normals_[corner / 3];
    if (theirs != passed.end())
      for (const std::size_t corner : theirs->second) sum += face_normals_[corner / 3];
    for (const std::size_t corner : ours) edge_normals_[corner] = sum;
  }
  if (open_edges_ == 0 && volume < 0.0) outwards_ = -1.0;
}

std::array<glm::dvec3, 3> ClosestSurface::corners(std::size_t triangle) const {
  std::array<glm::dvec3, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = glm::dvec3(mesh_.positions[mesh_.indices[3 * triangle + i]]);
  return at;
}

glm::dvec3 ClosestSurface::normal_at(std::size_t triangle, const TrianglePoint& nearest) const {
  const std::size_t corner = 3 * triangle + static_cast<std::size_t>(nearest.number);
  switch (nearest.feature) {
    case Feature::edge:
      return edge_normals_[corner];
    case Feature::corner:
      return corner_normals_[vertices_[corner]];
    case Feature::face:
      break;
  }
  return face_normals_[triangle];
}

double ClosestSurface::distance(const glm::dvec3& place) const {
  struct Search {
    const ClosestSurface& surface;
    glm::dvec3 place;
    double squared = std::numeric_limits<double>::infinity();
    std::size_t triangle = 0;
    TrianglePoint nearest{};
  } search{*this, place};
  const auto visit = [](RTCPointQueryFunctionArguments* asked) {
    auto& found = *static_cast<Search*>(asked->userPtr);
    const std::size_t triangle = found.surface.rays_.triangle(asked->geomID, asked->primID);
    const TrianglePoint nearest = nearest_on_triangle(found.place, found.surface.corners(triangle));
    const glm::dvec3 apart = found.place - nearest.point;
    const double squared = glm::dot(apart, apart);
    if (squared >= found.squared) return false;
    found.squared = squared;
    found.triangle = triangle;
    found.nearest = nearest;
    // The radius is a little larger, so that rounding to float leaves out nothing that is nearer.
    asked->query->radius = static_cast<float>(std::sqrt(squared) * (1.0 + 1e-6));
    return true;
  };
  RTCPointQuery query{static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z),
                      0.0F, std::numeric_limits<float>::infinity()};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(rays_.handle(), &query, &context, visit, &search);
  const double metres = std::sqrt(search.squared);
  const glm::dvec3 normal = normal_at(search.triangle, search.nearest);
  return outwards_ * glm::dot(place - search.nearest.point, normal) < 0.0 ? -metres : metres;
}

HighestSurface::HighestSurface(const EmbreeScene& rays, const scene::Scene& scene) : rays_(rays) {
  if (scene.mesh.positions.empty()) return;
  const parameters::Bounds bounds = scene.bounds();
  above_ = bounds.maximum.y + 1.0;
  middle_ = {0.5 * (bounds.minimum.x + bounds.maximum.x), 0.5 * (bounds.minimum.z + bounds.maximum.z)};
}

std::optional<double> HighestSurface::at(glm::dvec2 xz) const {
  const glm::vec2 place(xz);
  if (const std::optional<double> height = height_below(rays_, above_, place)) return height;
  // Embree's ray misses a box if it runs in the side of largest x or z, and so misses the scene's own edges.
  return height_below(rays_, above_,
                      {std::nextafter(place.x, middle_.x), std::nextafter(place.y, middle_.y)});
}

}  // namespace penumbra::reference
