#include "scene/face_normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

namespace penumbra::scene {
namespace {

constexpr double kCosOfSmoothingAngle = 0.5;  // 60 degrees
// A vertex with more faces than this (the tip of a finely tessellated cone) is smoothed over the first of
// them only: the loop below is quadratic.
constexpr std::size_t kLargestHub = 64;

struct Corner {
  std::size_t index;  // index into ModelFile::indices
  glm::dvec3 normal;  // unit normal of the corner's face
  double angle;       // angle between the corner's two edges
};

glm::dvec3 smoothed(const Corner& corner, const Corner* first, const Corner* last) {
  glm::dvec3 sum = corner.angle * corner.normal;
  for (const Corner* other = first; other != last; ++other) {
    if (other->index == corner.index) continue;
    if (glm::dot(corner.normal, other->normal) > kCosOfSmoothingAngle) sum += other->angle * other->normal;
  }
  return glm::normalize(sum);
}

std::vector<Corner> corners_without_normal(const ModelFile& model) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < model.indices.size(); ++i) {
    if (model.normals[model.indices[i]] != glm::dvec3(0.0)) continue;
    const std::size_t face = i - i % 3;
    const auto at = [&](std::size_t k) { return model.positions[model.indices[face + k % 3]]; };
    const glm::dvec3 next = at(i + 1 - face) - at(i - face), last = at(i + 2 - face) - at(i - face);
    const glm::dvec3 area = glm::cross(next, last);
    const double angle = std::atan2(glm::length(area), glm::dot(next, last));
    corners.push_back({i, glm::normalize(area), angle});
  }
  return corners;
}

}  // namespace

void add_missing_normals(ModelFile& model) {
  std::vector<Corner> corners = corners_without_normal(model);
  const auto place = [&](const Corner& corner) {
    const glm::dvec3& p = model.positions[model.indices[corner.index]];
    return std::tuple(p.x, p.y, p.z);
  };
  std::sort(corners.begin(), corners.end(), [&](const Corner& a, const Corner& b) {
    return std::tuple_cat(place(a), std::tuple(a.index)) < std::tuple_cat(place(b), std::tuple(b.index));
  });
  std::vector<glm::dvec3> normals(corners.size());
  for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
    while (end < corners.size() && place(corners[end]) == place(corners[begin])) ++end;
    const std::size_t hub = std::min(end - begin, kLargestHub);
    for (std::size_t i = begin; i < end; ++i) {
      normals[i] = smoothed(corners[i], corners.data() + begin, corners.data() + begin + hub);
    }
  }
  // Corners at one place with one normal and one place on the texture share a vertex.
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::uint32_t& index = model.indices[corners[i].index];
    const glm::dvec3 position = model.positions[index];
    const glm::dvec2 uv = model.uvs[index];
    const bool same = i > 0 && model.positions.back() == position && model.normals.back() == normals[i] &&
                      model.uvs.back() == uv;
    if (!same) {
      model.positions.push_back(position);
      model.normals.push_back(normals[i]);
      model.uvs.push_back(uv);
    }
    index = static_cast<std::uint32_t>(model.positions.size() - 1);
  }
}

}  // namespace penumbra::scene
