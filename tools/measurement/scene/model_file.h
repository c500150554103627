// The triangles and materials of a model file as the file means them: its own units, right-handed, nodes'
// transforms applied.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/model_materials.h"

namespace penumbra::scene {

// Winding is counter-clockwise seen from outside. A normal is zero where the file has none that can be used.
// Every position is finite and every index is in range.
struct ModelFile {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::vector<glm::dvec2> uvs;  // one per vertex, zero where the file has none; (0, 0) as Texture says
  std::vector<std::uint32_t> indices;
  std::vector<std::uint16_t> triangle_materials;  // one per triangle
  bool has_uvs = false;                           // some vertex has coordinates of its own
  ModelMaterials surface;
};

// Throws InputError as scene::import() does. Nothing is repaired or merged here: the importer library's own
// steps are limited to validation and triangulation, because each further one is a way for an unusual file to
// fail.
ModelFile read_model_file(const std::filesystem::path& file, std::size_t triangle_limit);

}  // namespace penumbra::scene
