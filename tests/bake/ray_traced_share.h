// The lit share of a disc light by rays, and distance fields as textures.
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "bake/field_objects.h"
#include "gpu/device.h"
#include "gpu/resources.h"
#include "reference/disc_samples.h"
#include "reference/embree_scene.h"

namespace penumbra::bake {

// A disc light seen in a direction, whose half angle has this tangent; rays are uniform on it.
struct SeenDisc {
  glm::dvec3 towards{0.0, 1.0, 0.0};
  double tan_half = 0.0;

  glm::dvec3 right() const { return glm::normalize(glm::cross(towards, glm::dvec3(0.0, 0.0, 1.0))); }
  glm::dvec3 up() const { return glm::cross(towards, right()); }
};

inline bool is_lit(const reference::EmbreeScene& rays, const glm::dvec3& from, const glm::dvec3& direction) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  ray.org_x = static_cast<float>(from.x);
  ray.org_y = static_cast<float>(from.y);
  ray.org_z = static_cast<float>(from.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tfar = 1e9F;
  ray.mask = ~0U;
  rtcOccluded1(rays.handle(), &context, &ray);
  return ray.tfar >= 0.0F;
}

inline double lit_share(const reference::EmbreeScene& rays, const glm::dvec3& from, const SeenDisc& light,
                        int count) {
  const glm::dvec3 right = light.right(), up = light.up();
  int lit = 0;
  for (int i = 0; i < count; ++i) {
    const glm::dvec2 place =
        reference::concentric_disc(reference::scrambled_sobol(static_cast<std::uint32_t>(i), 7));
    lit += is_lit(rays, from, light.towards + light.tan_half * (place.x * right + place.y * up)) ? 1 : 0;
  }
  return static_cast<double>(lit) / count;
}

inline gpu::Image texture_of(const gpu::Device& device, const std::array<int, 3>& voxels,
                             const std::vector<std::uint16_t>& texels) {
  gpu::ImageShape shape;
  shape.format = gpu::Format::r16;
  shape.width = voxels[0];
  shape.height = voxels[1];
  shape.depth = voxels[2];
  gpu::Image image(device, shape);
  image.upload(std::span<const std::uint16_t>(texels));
  return image;
}

// The uniforms of DistanceFieldScene.hlsl, in its order.
inline std::vector<glm::vec4> field_uniforms(const ObjectFields& fields) {
  std::vector<glm::vec4> all{fields.atlas()};
  const std::vector<glm::vec4> rows = fields.rows(glm::dvec3(0.0));
  all.insert(all.end(), rows.begin(), rows.end());
  all.resize(1 + 6 * static_cast<std::size_t>(most_field_objects));
  return all;
}

// Joins meshes into one.
inline scene::Scene joined(const std::vector<scene::Scene>& scenes) {
  scene::Scene all;
  all.name = "mesh";
  for (const scene::Scene& one : scenes) {
    const auto first = static_cast<std::uint32_t>(all.mesh.positions.size());
    all.mesh.positions.insert(all.mesh.positions.end(), one.mesh.positions.begin(), one.mesh.positions.end());
    all.mesh.normals.insert(all.mesh.normals.end(), one.mesh.normals.begin(), one.mesh.normals.end());
    for (const std::uint32_t index : one.mesh.indices) all.mesh.indices.push_back(first + index);
  }
  return all;
}

inline scene::Scene moved(scene::Scene scene, const glm::dvec3& by) {
  for (glm::vec3& position : scene.mesh.positions) position = glm::vec3(glm::dvec3(position) + by);
  return scene;
}

}  // namespace penumbra::bake
