// What is seen and what casts: triangles in metres, a camera at human height, a sun.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "parameters/cascades.h"

namespace penumbra::scene {

// Indexed triangles. Positions are relative to Scene::origin, so that a scene far from the world's origin
// keeps its shape; normals are unit, per vertex (as Unity's shadow caster pass reads them for normal bias).
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<std::uint32_t> indices;  // three per triangle

  std::size_t triangle_count() const { return indices.size() / 3; }
};

struct Scene {
  std::string name;
  std::string description;            // one line, for reports
  Mesh mesh;
  glm::dvec3 origin{0.0};             // world position of the mesh's own origin
  parameters::Camera camera;          // position relative to origin, like the mesh
  glm::dvec3 light_direction{0.4, -0.8, 0.45};  // the way the light travels
  double shadow_distance_metres = 50.0;

  parameters::Bounds bounds() const;  // of the mesh, relative to origin
};

// The names built_in() knows, in the order reports list them.
std::vector<std::string> built_in_names();

// A built-in scene; throws InputError naming the nearest known name otherwise. The same name gives the same
// bytes on every machine.
Scene built_in(std::string_view name);

struct ImportOptions {
  double metres_per_unit = 1.0;
  bool z_up = false;
  double height_metres = 0.0;   // when > 0, scale so that the model is this tall
  bool ground = true;           // put a ground plane under the model
};

// Reads glTF, GLB, OBJ, 3DS and what else the importer knows. Throws InputError naming the file and the reason:
// unreadable, empty, no triangles, non-finite vertices, indices out of range, too many triangles.
Scene import(const std::filesystem::path& file, const ImportOptions& options);

}  // namespace penumbra::scene
