#include "scene/content_hash.h"

#include <glm/vec3.hpp>
#include <string_view>

#include "platform/content_hash.h"
#include "scene/cut_out.h"
#include "scene/scene.h"

namespace penumbra::scene {
namespace {

using platform::ContentHash;

void update(ContentHash& hash, const glm::dvec3& vector) {
  hash.update(vector.x).update(vector.y).update(vector.z);
}

void update(ContentHash& hash, const CloudLayer& layer) {
  const auto& [altitude, feature, coverage, density] = layer;
  hash.update(std::string_view("clouds"));
  for (const double number : {altitude, feature, coverage, density}) hash.update(number);
}

}  // namespace

std::string content_hash(const Scene& scene) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "vertices are hashed as packed floats");
  ContentHash hash;
  hash.update(std::span<const glm::vec3>(scene.mesh.positions));
  hash.update(std::span<const glm::vec3>(scene.mesh.normals));
  hash.update(std::span<const std::uint32_t>(scene.mesh.indices));
  const parameters::Camera& camera = scene.camera;
  for (const glm::dvec3& vector :
       {scene.origin, scene.light_direction, camera.position, camera.forward, camera.up}) {
    update(hash, vector);
  }
  for (const double number : {camera.fov_y_degrees, camera.aspect, camera.near_plane, camera.far_plane,
                              scene.shadow_distance_metres}) {
    hash.update(number);
  }
  if (scene.seen_distance_metres > 0.0) hash.update(scene.seen_distance_metres);
  if (scene.clouds) update(hash, *scene.clouds);
  add_fields(hash, CutOuts(scene));
  return hash.hex();
}

}  // namespace penumbra::scene
