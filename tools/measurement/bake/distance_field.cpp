#include "bake/distance_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/input_error.h"
#include "platform/hashed_fields.h"
#include "reference/closest_surface.h"
#include "reference/embree_scene.h"

namespace penumbra::bake {
namespace {

constexpr int kDistancesVersion = 1;  // increased whenever a change affects any result

void check(const scene::Scene& scene, const DistanceFieldOptions& options) {
  if (scene.mesh.triangle_count() == 0)
    throw InputError("", "the scene '" + scene.name + "' has no triangles");
  for (const glm::vec3& position : scene.mesh.positions) {
    if (std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z)) continue;
    throw InputError("", "the scene '" + scene.name + "' has a vertex that is not a finite number");
  }
  if (options.voxels < least_voxels_per_side || options.voxels > most_voxels_per_side) {
    throw InputError("",
                     fmt::format("a distance field has from {} to {} voxels along its longest side, not {}",
                                 least_voxels_per_side, most_voxels_per_side, options.voxels));
  }
  if (!std::isfinite(options.margin) || options.margin < 0.0 || options.margin > 10.0)
    throw InputError("", fmt::format("a margin of {} of the mesh's longest side cannot be baked; 0 to 10 can",
                                     options.margin));
}

// The voxels are cubes; along its longest side, the mesh with both margins has as many as the options ask
// for.
void place_voxels(const scene::Scene& scene, const DistanceFieldOptions& options, DistanceField& field) {
  const parameters::Bounds bounds = scene.bounds();
  const glm::dvec3 size = bounds.maximum - bounds.minimum;
  const double longest = std::max({size.x, size.y, size.z});
  if (!(longest > 0.0)) throw InputError("", "the scene '" + scene.name + "' is a single point");
  const double margin = options.margin * longest;
  const double edge = (longest + 2.0 * margin) / options.voxels;
  for (int axis = 0; axis < 3; ++axis) {
    const int count = std::max(1, static_cast<int>(std::ceil((size[axis] + 2.0 * margin) / edge - 1e-9)));
    const double middle = 0.5 * (bounds.minimum[axis] + bounds.maximum[axis]);
    field.voxels[static_cast<std::size_t>(axis)] = count;
    field.box.minimum[axis] = middle - 0.5 * edge * count;
    field.box.maximum[axis] = middle + 0.5 * edge * count;
  }
}

std::string key_of(const scene::Scene& scene, const DistanceField& field) {
  return platform::hash_of("distances", kDistancesVersion, scene.mesh.positions, scene.mesh.indices,
                           field.voxels, field.box);
}

}  // namespace

glm::dvec3 DistanceField::centre(int x, int y, int z) const {
  const glm::dvec3 place(x + 0.5, y + 0.5, z + 0.5);
  return box.minimum + (box.maximum - box.minimum) * place / glm::dvec3(voxels[0], voxels[1], voxels[2]);
}

DistanceField placed_field(const scene::Scene& scene, const DistanceFieldOptions& options) {
  check(scene, options);
  DistanceField field;
  place_voxels(scene, options, field);
  return field;
}

DistanceField bake_distance_field(const scene::Scene& scene, const DistanceFieldOptions& options,
                                  const BakeOptions& run) {
  DistanceField field = placed_field(scene, options);
  scene::Scene solid = scene;  // holes in materials are not holes of the mesh
  solid.materials = {scene::Material{}};
  solid.textures.clear();
  solid.mesh.triangle_materials.clear();
  const reference::EmbreeScene rays(solid);
  const reference::ClosestSurface surface(rays, solid);
  field.open_edges = surface.open_edges();
  // Each block is a slice of one z.
  const BakeJob job{key_of(scene, field), field.voxels[2], [&](int z) {
                      std::vector<float> metres;
                      for (int y = 0; y < field.voxels[1]; ++y)
                        for (int x = 0; x < field.voxels[0]; ++x)
                          metres.push_back(static_cast<float>(surface.distance(field.centre(x, y, z))));
                      return metres;
                    }};
  field.metres = run_bake(job, run);
  return field;
}

}  // namespace penumbra::bake
