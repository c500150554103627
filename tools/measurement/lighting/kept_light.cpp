#include "lighting/kept_light.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "platform/byte_stream.h"
#include "platform/cache_folder.h"
#include "platform/cache_store.h"
#include "platform/content_hash.h"
#include "scene/cut_out.h"

namespace penumbra::lighting {
namespace {

constexpr std::string_view kKind = "light";
constexpr int kVersion = 1;  // increased whenever a change affects any result

std::string key_of(const scene::Scene& scene, const SeenMaterials& seen, const Surroundings& surroundings,
                   int rays) {
  platform::ContentHash hash;
  hash.update(kKind).update(kVersion).update(rays);
  hash.update(std::span<const glm::vec3>(scene.mesh.positions));
  hash.update(std::span<const std::uint32_t>(scene.mesh.indices));
  hash.update(std::span<const std::uint16_t>(scene.mesh.triangle_materials));
  scene::CutOuts(scene).add_to(hash);
  hash.update(std::span<const glm::vec3>(mean_colours(scene)));
  for (const scene::Material& material : scene.materials) hash.update(double(material.translucency));
  hash.update(surroundings.sky.table());
  hash.update(std::span<const glm::vec3>(&surroundings.to_sun, 1));
  hash.update(std::span<const glm::vec3>(&surroundings.sun, 1));
  hash.update(seen.width).update(seen.height);
  hash.update(std::span<const std::uint8_t>(seen.seen));
  for (const SurfacePoint& point : seen.points) {
    hash.update(std::span<const glm::vec3>(&point.position, 1));
    hash.update(std::span<const glm::vec3>(&point.flat_normal, 1));
    hash.update(std::span<const glm::vec3>(&point.normal, 1));
    hash.update(double(point.translucency));
  }
  return hash.hex();
}

}  // namespace

std::vector<glm::vec3> kept_sky_light(const scene::Scene& scene, const SeenMaterials& seen,
                                      const Surroundings& surroundings, int rays,
                                      const std::filesystem::path& folder, const reference::RunOptions& run) {
  const std::string key = key_of(scene, seen, surroundings, rays);
  const platform::CacheStore store(folder.empty() ? platform::cache_directory("reference") : folder);
  if (const std::optional<std::string> entry = store.find(kKind, key)) {
    platform::ByteReader reader(*entry);
    std::vector<glm::vec3> kept = reader.values<glm::vec3>();
    if (reader.exhausted() && kept.size() == seen.points.size()) return kept;
  }
  std::vector<glm::vec3> light = sky_light(scene, seen, surroundings, rays, run);
  platform::ByteWriter writer;
  writer.values(light);
  store.store(kKind, key, writer.take());
  return light;
}

}  // namespace penumbra::lighting
