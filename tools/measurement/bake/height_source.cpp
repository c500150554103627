#include "bake/height_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "input/input_error.h"
#include "platform/hashed_fields.h"
#include "reference/closest_surface.h"
#include "reference/embree_scene.h"
#include "scene/content_hash.h"

namespace penumbra::bake {
namespace {

constexpr int kHeightsVersion = 2;  // increased whenever a change affects any result
constexpr float kNothing = std::numeric_limits<float>::lowest();

std::string height_key(const scene::Scene& scene, const Area& area, const SampleCounts& counts) {
  return platform::hash_of("heights", kHeightsVersion, scene::content_hash(scene), area, counts);
}

}  // namespace

scene::Scene ground_of(const scene::Scene& scene) {
  scene::Scene ground = scene;
  if (ground.ground_triangles == 0) return ground;
  ground.mesh.indices.resize(3 * ground.ground_triangles);
  if (!ground.mesh.triangle_materials.empty()) ground.mesh.triangle_materials.resize(ground.ground_triangles);
  std::uint32_t used = 0;
  for (const std::uint32_t index : ground.mesh.indices) used = std::max(used, index + 1);
  ground.mesh.positions.resize(used);
  ground.mesh.normals.resize(used);
  if (!ground.mesh.uvs.empty()) ground.mesh.uvs.resize(used);
  return ground;
}

SampleCounts even_counts(const Area& area, int longest) {
  const double spacing = std::max(area.size.x, area.size.y) / (longest - 1);
  const auto count = [&](double side) {
    return std::max(2, static_cast<int>(std::lround(side / spacing)) + 1);
  };
  return {count(area.size.x), count(area.size.y)};
}

Area area_of(const scene::Scene& scene) {
  const parameters::Bounds bounds = scene.bounds();
  return {{bounds.minimum.x, bounds.minimum.z},
          {bounds.maximum.x - bounds.minimum.x, bounds.maximum.z - bounds.minimum.z}};
}

HeightField heights_of_scene(const scene::Scene& scene, const Area& area, const SampleCounts& counts,
                             const BakeOptions& run) {
  check_grid(counts.width, counts.depth, area);
  HeightField field{counts.width, counts.depth, area, {}};
  const reference::EmbreeScene rays(scene);
  const reference::HighestSurface surface(rays, scene);
  // Each block is a row.
  const BakeJob job{height_key(scene, area, counts), counts.depth, [&](int row) {
                      std::vector<float> metres;
                      for (int x = 0; x < field.width; ++x) {
                        const glm::dvec2 place = area.corner + field.spacing() * glm::dvec2(x, row);
                        const std::optional<double> height = surface.at(place);
                        metres.push_back(height ? static_cast<float>(*height) : kNothing);
                      }
                      return metres;
                    }};
  field.metres = run_bake(job, run);
  const auto lowest = static_cast<float>(scene.mesh.positions.empty() ? 0.0 : scene.bounds().minimum.y);
  bool any = false;
  for (float& metres : field.metres) {
    any = any || metres != kNothing;
    if (metres != kNothing) continue;
    metres = lowest;
    ++field.holes;
  }
  if (!any) {
    throw InputError(
        "",
        fmt::format("the scene '{}' has no surface over the area from {}, {} to {}, {} metres", scene.name,
                    area.corner.x, area.corner.y, area.corner.x + area.size.x, area.corner.y + area.size.y));
  }
  return field;
}

HeightField heights_of_image(const scene::HeightImage& image, const Area& area, const HeightRange& range,
                             bool from_largest_z) {
  const auto possible = [](double metres) { return std::abs(metres) <= most_ground_metres; };
  if (!possible(range.low) || !possible(range.high) || range.low >= range.high) {
    throw InputError(
        "",
        fmt::format("heights cannot go from {} to {} metres: the first is the lower, and both lie "
                    "within {} metres of 0",
                    range.low, range.high, most_ground_metres),
        "give the heights of 0 and of 65535, such as --heights 0,600");
  }
  HeightField field{image.width, image.height, area, {}};
  field.metres.reserve(image.samples.size());
  for (int z = 0; z < image.height; ++z) {
    const int row = from_largest_z ? image.height - 1 - z : z;
    for (int x = 0; x < image.width; ++x) {
      const std::size_t at =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
      field.metres.push_back(
          static_cast<float>(std::lerp(range.low, range.high, image.samples[at] / 65535.0)));
    }
  }
  check_height_field(field);
  return field;
}

}  // namespace penumbra::bake
