// A scene: triangles in metres, a camera at human height, a sun or a spot light.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parameters/cascades.h"
#include "parameters/spot_light.h"
#include "scene/clouds.h"
#include "scene/material.h"
#include "scene/reading_process.h"

namespace penumbra::scene {

// Indexed triangles. Positions are relative to Scene::origin, so that a scene far from the world's origin
// keeps its shape; normals are unit, per vertex (as Unity's shadow caster pass reads them for normal bias).
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<std::uint32_t> indices;  // three per triangle
  std::vector<glm::vec2> uvs;          // one per vertex, or none at all; Texture says where (0, 0) is
  std::vector<std::uint16_t> triangle_materials;  // one per triangle, or none at all: then all have the first

  std::size_t triangle_count() const { return indices.size() / 3; }
  std::size_t material_of(std::size_t triangle) const {
    return triangle_materials.empty() ? 0 : triangle_materials[triangle];
  }
};

struct Scene {
  std::string name;
  std::string description;         // one line, for reports
  std::vector<std::string> notes;  // what an import left out; a line each, for people
  Mesh mesh;
  std::vector<Material> materials{Material{}};  // at least one
  std::vector<Texture> textures;
  glm::dvec3 origin{0.0};                       // world position of the mesh's own origin
  parameters::Camera camera;                    // position relative to origin, like the mesh
  glm::dvec3 light_direction{0.4, -0.8, 0.45};  // the way the sun's light travels
  // Instead of the sun; its position relative to origin, like the mesh.
  std::optional<parameters::SpotLight> spot_light{};
  double shadow_distance_metres = 50.0;
  // How far from the camera surfaces are receivers, where that is farther than the shadow distance: of scenes
  // with far shadows.
  double seen_distance_metres = 0.0;
  // So many triangles, the first of the mesh, are the ground that far shadows are baked from; 0: all are.
  std::size_t ground_triangles = 0;
  std::optional<CloudLayer> clouds{};  // over the scene

  parameters::Bounds bounds() const;  // of the mesh, relative to origin
};

// Light of a sun that stands elevation degrees above the horizon, azimuth degrees from +Z towards +X: the
// unit vector along which it travels. Throws InputError unless 0 < elevation <= 90.
glm::dvec3 sunlight(double elevation_degrees, double azimuth_degrees);

// The direction of sunlight before the sun moved on by so many degrees of the sky, straight on in the
// direction of its daily arc at 45 degrees north, which is about the axis halfway between the zenith and +Z.
// At most kOldestMapDegrees.
inline constexpr double kOldestMapDegrees = 10.0;
glm::dvec3 sun_before(const glm::dvec3& light_direction, double degrees);

// A camera with default lens at position (metres, relative to the mesh's origin) that looks at target.
parameters::Camera camera_looking(const glm::dvec3& position, const glm::dvec3& target);

// The names of built-in scenes that the sun lights, in the order reports list them.
std::vector<std::string> built_in_names();

// Of those with a spot light. They are measured when they are named: most techniques are not for them.
std::vector<std::string> spot_scene_names();

// Of those under the sun with casters that blend. They are measured when they are named: most techniques do
// not draw such casters.
std::vector<std::string> blended_scene_names();

// Of a landscape whose shadows reach beyond the cascades, under the sun at several elevations. They are
// measured when they are named: most techniques end at the shadow distance.
std::vector<std::string> landscape_scene_names();

// Of all four kinds.
std::vector<std::string> all_built_in_names();

// A built-in scene, of any kind; throws InputError naming the nearest known name otherwise. The same name
// gives the same bytes on every machine.
Scene built_in(std::string_view name);

// Its description, without building it; throws as built_in() does.
std::string built_in_description(std::string_view name);

struct ImportOptions {
  double metres_per_unit = 1.0;
  bool z_up = false;
  bool minus_z_up = false;  // a 3DS file drawn with +Y up: its reader turns every 3DS file as if +Z were up
  double height_metres = 0.0;  // when > 0, scale so that the model is this tall
  bool ground = true;          // put a ground plane under the model
  std::size_t triangle_limit = 20'000'000;
  ReadingProcess process{};  // of load() and package_model(); import() reads in this process
};

// Reads glTF, GLB, OBJ, 3DS, PLY, STL, Collada and FBX. Throws InputError naming the file and the
// reason: unreadable, empty, broken, no triangles, non-finite vertices, indices out of range, too many
// triangles.
//
// Files are right-handed with +Y up (or +Z with z_up) and become Unity's left-handed space as Unity's glTF
// importers do it: x changes its sign, and with it the winding. The model is moved so that its box stands on
// y = 0 with its centre over the origin; the camera frames it and its shadow (framing.h). Materials and
// textures come with it (scene/model_materials.h); a texture that cannot be loaded causes a note. Triangles
// without area are dropped; vertices without a usable normal get their face's.
Scene import(const std::filesystem::path& file, const ImportOptions& options);

// A real model that a Debian package brings; never part of this repository.
struct PackageModel {
  std::string name;  // "glmark2/horse"; users write "package:glmark2/horse"
  std::string debian_package;
  std::filesystem::path file;  // below the share folder, /usr/share
  std::string description;
  double height_metres;     // the model's units are unknown: it is scaled to this height
  bool minus_z_up = false;  // as ImportOptions has it
};
const std::vector<PackageModel>& package_models();

// Imports a package's model from below share. Throws InputError for an unknown name, EnvironmentError naming
// the package where the file is missing. options.height_metres and metres_per_unit replace the model's own
// height.
Scene package_model(std::string_view name, const ImportOptions& options = {},
                    const std::filesystem::path& share = "/usr/share");

// The names that load() knows of scenes that the sun lights, in the order reports list them: built-in ones,
// then "package:" ones.
std::vector<std::string> scene_names();

// The argument of --scene: a built-in name, "package:NAME", or the path of a file. For anything else, throws
// InputError suggesting the nearest name.
Scene load(std::string_view name_or_file, const ImportOptions& options = {});

}  // namespace penumbra::scene
