// Distance fields of a scene's objects, side by side in one 3D texture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "bake/distance_field.h"
#include "bake/scene_objects.h"

namespace penumbra::bake {

struct ObjectField {
  DistanceField field;
  std::array<int, 3> first{};   // voxel of the texture at which the field begins, along x, y and z
  double largest_metres = 0.0;  // the largest distance, which the texture's largest value stands for
  std::size_t triangles = 0;
  std::size_t parts = 0;    // number of parts that do not touch one another
  double thin_share = 0.0;  // share of the surface too thin for the field: less than two voxels behind it
};

struct ObjectFields {
  std::array<int, 3> voxels{};  // the texture's voxels along x, y and z
  std::vector<ObjectField> objects;
  std::size_t ground_triangles = 0;  // triangles that belong to no object
  std::size_t flat_triangles = 0;    // triangles without area, which belong to no object

  // The texture's texels, x fastest, then y: distances from -largest_metres (0) to largest_metres (65535) of
  // each object, and 65535 beside them.
  std::vector<std::uint16_t> texels() const;

  // The values that ShaderLibrary/Fields/DistanceFieldScene.hlsl reads: _PenumbraFieldAtlas, and the six rows
  // of each object in _PenumbraFieldObjects. The objects stand where they were baked; `origin` is the scene's
  // origin in the world.
  glm::vec4 atlas() const;
  std::vector<glm::vec4> rows(const glm::dvec3& origin) const;
};

struct ObjectFieldsOptions {
  int objects = most_field_objects;  // the largest number of objects
  DistanceFieldOptions each{};       // a margin of less than a voxel becomes a voxel
};

inline constexpr int least_voxels_of_objects = 8;   // per side
inline constexpr int largest_field_texture = 2048;  // texels per side, which all desktop GPUs have

// Throws InputError as objects_of() and bake_distance_field() do, for fewer voxels than
// least_voxels_of_objects, and where the texture would be larger than largest_field_texture; Interrupted as
// run_bake().
ObjectFields bake_object_fields(const scene::Scene& scene, const ObjectFieldsOptions& options,
                                const BakeOptions& run = {});

// The boxes' places in a box that holds them all without overlap, in rows along x that stand beside one
// another along y. packed_boxes() throws InputError if that box had more than `largest` voxels per side.
struct PackedBoxes {
  std::array<int, 3> size{};
  std::vector<std::array<int, 3>> first;  // the place of each box
};
PackedBoxes packed_boxes(const std::vector<std::array<int, 3>>& sizes, int largest);

}  // namespace penumbra::bake
