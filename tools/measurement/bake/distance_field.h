// The distance to a mesh on a grid of voxels in a box around it: shadows are marched through it without
// triangles.
//
// Distances are metres, negative inside; their signs are right for closed meshes (reference/closest_surface.h
// says what they are for others). Space: relative to the scene's origin, like its mesh.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "bake/block_run.h"
#include "scene/scene.h"

namespace penumbra::bake {

struct DistanceField {
  std::array<int, 3> voxels{};  // along x, y and z
  parameters::Bounds box{};     // voxels' centres are those of equal parts of it
  std::vector<float> metres;    // x runs fastest, then y
  std::size_t open_edges = 0;   // the mesh's; above 0 signs are those of the nearest triangle's side

  glm::dvec3 centre(int x, int y, int z) const;
  float at(int x, int y, int z) const {
    return metres[(static_cast<std::size_t>(z) * voxels[1] + y) * voxels[0] + x];
  }
};

struct DistanceFieldOptions {
  int voxels = 64;      // along the mesh's longest side; the others have as many as make the voxels cubes
  double margin = 0.1;  // share of the longest side, added on every side of the mesh
};

// The number counts voxels along the mesh's longest side. A single voxel is one distance, which has no shape.
inline constexpr int least_voxels_per_side = 2;
inline constexpr int most_voxels_per_side = 512;

// The voxels and the box of a field, without distances. Throws InputError as bake_distance_field().
DistanceField placed_field(const scene::Scene& scene, const DistanceFieldOptions& options);

// Throws InputError for a mesh without triangles or with a vertex that is not a finite number, and for
// unusable options; as run_bake.
DistanceField bake_distance_field(const scene::Scene& scene, const DistanceFieldOptions& options,
                                  const BakeOptions& run = {});

}  // namespace penumbra::bake
