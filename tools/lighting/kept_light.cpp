#include "lighting/kept_light.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "platform/content_hash.h"
#include "platform/terminal.h"
#include "reference/cache_entry.h"
#include "scene/cut_out.h"

namespace penumbra::lighting {
namespace {

constexpr std::string_view kTitle = "penumbra sky light 1\n";  // a change of any result takes the next number

std::string key_of(const scene::Scene& scene, const SeenMaterials& seen, const Surroundings& surroundings,
                   int rays) {
  platform::ContentHash hash;
  hash.update(kTitle).update(rays);
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
  const std::filesystem::path file =
      (folder.empty() ? platform::cache_directory() / "reference" : folder) / (key + ".light");
  if (auto entry = reference::CacheEntryReader::open(file, kTitle, key)) {
    std::vector<glm::vec3> kept = entry->take<glm::vec3>(seen.points.size());
    if (entry->exhausted()) return kept;
  }
  std::vector<glm::vec3> light = sky_light(scene, seen, surroundings, rays, run);
  reference::CacheEntryWriter entry(kTitle, key);
  entry.append(std::span<const glm::vec3>(light));
  entry.write(file);
  return light;
}

}  // namespace penumbra::lighting
