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
  double largest_metres = 0.0;  // of the distances: what the texture's largest value means
  std::size_t triangles = 0;
  std::size_t parts = 0;  // that do not touch one another
  double thin_share =
      0.0;  // of the surface: with less than two voxels behind it, which the field does not hold
};

struct ObjectFields {
  std::array<int, 3> voxels{};  // of the texture
  std::vector<ObjectField> objects;
  std::size_t ground_triangles = 0;  // of no object
  std::size_t flat_triangles = 0;    // without area, of no object

  // The texture's texels, x fastest, then y: distances from -largest_metres (0) to largest_metres (65535) of
  // each object, and 65535 beside them.
  std::vector<std::uint16_t> texels() const;

  // What ShaderLibrary/Fields/DistanceFieldScene.hlsl reads: _PenumbraFieldAtlas, and the six rows of each
  // object in _PenumbraFieldObjects, the objects being where they were baked. origin: the scene's, in the
  // world.
  glm::vec4 atlas() const;
  std::vector<glm::vec4> rows(const glm::dvec3& origin) const;
};

struct ObjectFieldsOptions {
  int objects = most_field_objects;  // at most
  DistanceFieldOptions each{};       // a margin of less than a voxel becomes a voxel
};

inline constexpr int least_voxels_of_objects = 8;   // per side
inline constexpr int largest_field_texture = 2048;  // texels per side, which all desktop GPUs have

// Throws InputError as objects_of() and bake_distance_field() do, for fewer voxels than
// least_voxels_of_objects, and where the texture would be larger than largest_field_texture; Interrupted as
// run_bake().
ObjectFields bake_object_fields(const scene::Scene& scene, const ObjectFieldsOptions& options,
                                const BakeOptions& run = {});

// Where boxes of these sizes lie in one that holds them all without overlap, in rows along x that stand
// beside one another along y. Throws InputError where it had more than `largest` voxels per side.
struct PackedBoxes {
  std::array<int, 3> size{};
  std::vector<std::array<int, 3>> first;  // of each box
};
PackedBoxes packed_boxes(const std::vector<std::array<int, 3>>& sizes, int largest);

}  // namespace penumbra::bake
