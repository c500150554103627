// The triangles of a model file as the file means them: its own units, right-handed, nodes' transforms
// applied.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <vector>

namespace penumbra::scene {

// Winding is counter-clockwise seen from outside. A normal is zero where the file has none that can be used.
// Every position is finite and every index is in range.
struct ModelFile {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::vector<std::uint32_t> indices;
};

// Throws InputError as scene::import() does. Nothing is repaired or joined here: the importer's own steps are
// kept to validation and triangulation, since each further one is a way for an odd file to fail.
ModelFile read_model_file(const std::filesystem::path& file, std::size_t triangle_limit);

}  // namespace penumbra::scene
