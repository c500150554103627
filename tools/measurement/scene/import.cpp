#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <sstream>

#include "input/input_error.h"
#include "scene/face_normals.h"
#include "scene/framing.h"
#include "scene/mesh_builder.h"
#include "scene/model_file.h"
#include "scene/scene.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

constexpr double kSmallestExtent = 1e-3;  // metres; a smaller or larger model has the wrong unit
constexpr double kLargestExtent = 1e4;

std::string shown(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

void check_options(const ImportOptions& options) {
  if (!std::isfinite(options.metres_per_unit) || options.metres_per_unit <= 0.0) {
    throw InputError("", "metres per unit must be a positive number, not " + shown(options.metres_per_unit));
  }
  if (!std::isfinite(options.height_metres) || options.height_metres < 0.0) {
    throw InputError("", "the height must be zero (as the file has it) or a positive number of metres, not " +
                             shown(options.height_metres));
  }
  if (options.z_up && options.minus_z_up) throw InputError("", "either +Z or -Z is up, not both");
}

// Turns the axis that is up, +Z or -Z, to +Y: a quarter turn about x, which keeps the winding.
void stand_up(ModelFile& model, double sign) {
  for (auto* vectors : {&model.positions, &model.normals}) {
    for (glm::dvec3& v : *vectors) v = {v.x, sign * v.z, -sign * v.y};
  }
}

// A nearly degenerate triangle loses its area when its corners are rounded from double to float: it is
// removed here.
void drop_triangles_without_area(ModelFile& model) {
  constexpr double flat = 1e-7;  // area over longest edge squared, about float's rounding
  std::vector<std::uint32_t> kept;
  std::vector<std::uint16_t> materials;
  for (std::size_t i = 0; i + 2 < model.indices.size(); i += 3) {
    const glm::dvec3 a = model.positions[model.indices[i]];
    const glm::dvec3 b = model.positions[model.indices[i + 1]];
    const glm::dvec3 c = model.positions[model.indices[i + 2]];
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    const double area = glm::length(glm::cross(b - a, c - a));
    if (area > flat * longest * longest) {
      kept.insert(kept.end(), model.indices.begin() + static_cast<std::ptrdiff_t>(i),
                  model.indices.begin() + static_cast<std::ptrdiff_t>(i) + 3);
      materials.push_back(model.triangle_materials[i / 3]);
    }
  }
  model.indices = std::move(kept);
  model.triangle_materials = std::move(materials);
}

// The bounds are those of the vertices that triangles use: stray ones do not count.
parameters::Bounds bounds_of(const ModelFile& model) {
  parameters::Bounds bounds{glm::dvec3(std::numeric_limits<double>::infinity()),
                            glm::dvec3(-std::numeric_limits<double>::infinity())};
  for (const std::uint32_t index : model.indices) {
    bounds.minimum = glm::min(bounds.minimum, model.positions[index]);
    bounds.maximum = glm::max(bounds.maximum, model.positions[index]);
  }
  return bounds;
}

// Returns metres per unit of the file, from the options and the model's own size.
double scale_of(const parameters::Bounds& bounds, const ImportOptions& options,
                const std::filesystem::path& file) {
  const glm::dvec3 extent = bounds.maximum - bounds.minimum;
  const double largest = std::max({extent.x, extent.y, extent.z});
  double scale = options.metres_per_unit;
  if (options.height_metres > 0.0) {
    if (extent.y < 1e-6 * largest) {
      throw InputError(file.string(),
                       "has no height that could be scaled to " + shown(options.height_metres) + " m",
                       "give metres per unit instead, or set that +Z is up");
    }
    scale = options.height_metres / extent.y;
  }
  const double metres = scale * largest;
  if (!(metres >= kSmallestExtent && metres <= kLargestExtent)) {
    throw InputError(file.string(),
                     "is " + shown(metres) + " m across; a scene has between " + shown(kSmallestExtent) +
                         " m and " + shown(kLargestExtent) + " m",
                     options.height_metres > 0.0
                         ? "give another height in metres, or metres per unit in its place"
                         : "give metres per unit: --metres-per-unit 0.01 for a file in centimetres");
  }
  return scale;
}

// Places the mesh in Unity's left-handed space: x and with it the winding change sign. Only vertices in use
// are kept.
Mesh placed_mesh(const ModelFile& model, const parameters::Bounds& bounds, double scale) {
  const glm::dvec3 base{0.5 * (bounds.minimum.x + bounds.maximum.x), bounds.minimum.y,
                        0.5 * (bounds.minimum.z + bounds.maximum.z)};
  constexpr auto unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(model.positions.size(), unused);
  Mesh mesh;
  for (std::size_t i = 0; i < model.indices.size(); ++i) {
    const std::size_t mirrored = i % 3 == 0 ? i : (i % 3 == 1 ? i + 1 : i - 1);
    const std::uint32_t from = model.indices[mirrored];
    if (place[from] == unused) {
      place[from] = static_cast<std::uint32_t>(mesh.positions.size());
      const glm::dvec3 position = scale * (model.positions[from] - base);
      mesh.positions.emplace_back(-position.x, position.y, position.z);
      const glm::dvec3& normal = model.normals[from];
      mesh.normals.emplace_back(-normal.x, normal.y, normal.z);
      if (model.has_uvs) mesh.uvs.emplace_back(model.uvs[from]);
    }
    mesh.indices.push_back(place[from]);
  }
  mesh.triangle_materials = model.triangle_materials;
  return mesh;
}

// `more` has texture coordinates, which are dropped where `mesh` has none.
void append(Mesh& mesh, const Mesh& more, std::uint16_t material) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
  if (!mesh.uvs.empty()) mesh.uvs.insert(mesh.uvs.end(), more.uvs.begin(), more.uvs.end());
  for (const std::uint32_t index : more.indices) mesh.indices.push_back(first + index);
  mesh.triangle_materials.insert(mesh.triangle_materials.end(), more.triangle_count(), material);
}

// The shadow distance is that of a game, 50 m, and less for a small model.
double shadow_distance(const parameters::Bounds& box, double reach) {
  const double size = glm::distance(box.minimum, box.maximum);
  return std::max(1.1 * reach, std::min(50.0, 25.0 * size));
}

}  // namespace

Scene import(const std::filesystem::path& file, const ImportOptions& options) {
  check_options(options);
  ModelFile model = read_model_file(file, options.triangle_limit);
  if (options.z_up || options.minus_z_up) stand_up(model, options.z_up ? 1.0 : -1.0);
  drop_triangles_without_area(model);
  if (model.indices.empty()) throw InputError(file.string(), "has only triangles without area");
  add_missing_normals(model);
  const parameters::Bounds bounds = bounds_of(model);
  const double scale = scale_of(bounds, options, file);

  Scene scene;
  scene.name = file.stem().string();
  scene.mesh = placed_mesh(model, bounds, scale);
  scene.materials = std::move(model.surface.materials);
  scene.textures = std::move(model.surface.textures);
  scene.notes = std::move(model.surface.notes);
  scene.description =
      std::to_string(scene.mesh.triangle_count()) + " triangles from " + file.filename().string();
  const parameters::Bounds box = scene.bounds();
  scene.light_direction = sunlight(45.0, 50.0);
  scene.camera = framing_camera(box, scene.light_direction);
  scene.shadow_distance_metres = shadow_distance(box, framed_reach(scene.camera, box, scene.light_direction));
  scene.camera.far_plane = std::max(scene.camera.far_plane, 2.0 * scene.shadow_distance_metres);
  if (options.ground) {
    MeshBuilder ground;
    ground.ground({0.0, 0.0, 0.0}, 1.2 * scene.shadow_distance_metres);
    const std::size_t material = scene.materials.size();
    scene.materials.push_back(surfaces::concrete());
    append(scene.mesh, ground.take(), static_cast<std::uint16_t>(material));
  }
  return scene;
}

}  // namespace penumbra::scene
