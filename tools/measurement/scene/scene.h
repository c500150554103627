// A scene: triangles in metres, a camera at human height, a sun.
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
#include "scene/material.h"
#include "scene/reading_process.h"

namespace penumbra::scene {

// The layer is a level plane. Defaults are those of CloudParameters in ShaderLibrary/Far, which a test
// compares.
struct CloudLayer {
  double altitude_metres = 1600.0;  // world space
  double feature_metres = 2400.0;   // size of the largest octave of the noise
  double coverage = 0.45;           // 0 is none, 1 everywhere
  double density = 4.0;             // optical depth where the noise is highest

  bool operator==(const CloudLayer&) const = default;
};

// Returns the share of light, in [0, 1], that passes the layer straight up at a place: x and z in world
// space, metres.
double cloud_transmittance(const CloudLayer& layer, const glm::dvec2& place);

// Indexed triangles. Positions are relative to Scene::origin, so that a scene far from the world's origin
// keeps its shape; normals are unit, per vertex (as Unity's shadow caster pass reads them for normal bias).
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<std::uint32_t> indices;             // three for each triangle
  std::vector<glm::vec2> uvs;                     // one per vertex, or empty; Texture defines (0, 0)
  std::vector<std::uint16_t> triangle_materials;  // one per triangle; if empty, all have the first material

  std::size_t triangle_count() const { return indices.size() / 3; }
  std::size_t material_of(std::size_t triangle) const {
    return triangle_materials.empty() ? 0 : triangle_materials[triangle];
  }
};

struct Scene {
  std::string name;
  std::string description;         // one line for reports
  std::vector<std::string> notes;  // parts of a file that were left out; a line each for people
  Mesh mesh;
  std::vector<Material> materials{Material{}};  // at least one
  std::vector<Texture> textures;
  glm::dvec3 origin{0.0};                       // world position of the mesh's own origin
  parameters::Camera camera;                    // position relative to origin, like the mesh
  glm::dvec3 light_direction{0.4, -0.8, 0.45};  // the direction in which the sun's light travels
  double shadow_distance_metres = 50.0;
  // The distance from the camera up to which surfaces are receivers, where that is farther than the shadow
  // distance: in scenes with far shadows.
  double seen_distance_metres = 0.0;
  // The number of triangles, the first of the mesh, that are the ground from which far shadows are baked; 0
  // means all.
  std::size_t ground_triangles = 0;
  std::optional<CloudLayer> clouds{};  // clouds over the scene

  parameters::Bounds bounds() const;  // bounds of the mesh, relative to origin
};

// Returns the light of a sun that stands `elevation` degrees above the horizon, `azimuth` degrees from +Z
// towards +X: the unit vector along which it travels. Throws InputError unless 0 < elevation <= 90.
glm::dvec3 sunlight(double elevation_degrees, double azimuth_degrees);

// Returns the direction of sunlight before the sun moved on by so many degrees of the sky, in the direction
// of its daily arc at 45 degrees north, which is about the axis halfway between the zenith and +Z. The age is
// at most kOldestMapDegrees.
inline constexpr double kOldestMapDegrees = 10.0;
glm::dvec3 sun_before(const glm::dvec3& light_direction, double degrees);

// Returns a camera with the default lens at `position` (metres, relative to the mesh's origin) that looks at
// `target`.
parameters::Camera camera_looking(const glm::dvec3& position, const glm::dvec3& target);

// Returns the names of the built-in scenes that stand for those of games, in the order in which reports list
// them.
std::vector<std::string> built_in_names();

// Returns the names of all built-in scenes. Those that are not above are measured only when they are named:
// their casters blend, their shadows lie over each other, or their ground reaches beyond the shadow distance.
std::vector<std::string> all_built_in_names();

// Returns a built-in scene; throws InputError naming the nearest known name otherwise. The same
// name gives the same bytes on every machine.
Scene built_in(std::string_view name);

// Returns the scene's description without building it; throws as built_in() does.
std::string built_in_description(std::string_view name);

struct ImportOptions {
  double metres_per_unit = 1.0;
  bool z_up = false;
  bool minus_z_up = false;  // a 3DS file drawn with +Y up: its reader turns every 3DS file as if +Z were up
  double height_metres = 0.0;  // if > 0, the model is scaled to this height
  bool ground = true;          // puts a ground plane under the model
  std::size_t triangle_limit = 20'000'000;
  ReadingProcess process{};  // for load() and package_model(); import() reads in this process
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

// A real model that a Debian package provides; it is never part of this repository.
struct PackageModel {
  std::string name;  // "glmark2/horse"; users write "package:glmark2/horse"
  std::string debian_package;
  std::filesystem::path file;  // below the share folder, /usr/share
  std::string description;
  double height_metres;     // the model's units are unknown: it is scaled to this height
  bool minus_z_up = false;  // as in ImportOptions
};
const std::vector<PackageModel>& package_models();

// Imports a package's model from below share. Throws InputError for an unknown name, EnvironmentError naming
// the package where the file is missing. options.height_metres and metres_per_unit replace the model's own
// height.
Scene package_model(std::string_view name, const ImportOptions& options = {},
                    const std::filesystem::path& share = "/usr/share");

// Returns the names that load() knows of scenes that the sun lights, in the order in which reports list them:
// built-in ones, then "package:" ones.
std::vector<std::string> scene_names();

// Returns the scene that --scene names: a built-in name, "package:NAME", or the path of a file. For anything
// else, throws InputError suggesting the nearest name.
Scene load(std::string_view name_or_file, const ImportOptions& options = {});

}  // namespace penumbra::scene
