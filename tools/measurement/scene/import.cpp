#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <sstream>
#include <tuple>

#include "input/input_error.h"
#include "scene/framing.h"
#include "scene/mesh_builder.h"
#include "scene/model_file.h"
#include "scene/scene.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

constexpr double kCosOfSmoothingAngle = 0.5;  // 60 degrees
// A vertex with more faces than this (the tip of a finely tessellated cone) is smoothed over the first of
// them only: the loop below is quadratic.
constexpr std::size_t kLargestHub = 64;

struct Corner {
  std::size_t index;  // index into ModelFile::indices
  glm::dvec3 normal;  // unit normal of the corner's face
  double angle;       // angle between the corner's two edges
};

glm::dvec3 smoothed(const Corner& corner, const Corner* first, const Corner* last) {
  glm::dvec3 sum = corner.angle * corner.normal;
  for (const Corner* other = first; other != last; ++other) {
    if (other->index == corner.index) continue;
    if (glm::dot(corner.normal, other->normal) > kCosOfSmoothingAngle) sum += other->angle * other->normal;
  }
  return glm::normalize(sum);
}

std::vector<Corner> corners_without_normal(const ModelFile& model) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < model.indices.size(); ++i) {
    if (model.normals[model.indices[i]] != glm::dvec3(0.0)) continue;
    const std::size_t face = i - i % 3;
    const auto at = [&](std::size_t k) { return model.positions[model.indices[face + k % 3]]; };
    const glm::dvec3 next = at(i + 1 - face) - at(i - face), last = at(i + 2 - face) - at(i - face);
    const glm::dvec3 area = glm::cross(next, last);
    const double angle = std::atan2(glm::length(area), glm::dot(next, last));
    corners.push_back({i, glm::normalize(area), angle});
  }
  return corners;
}

// Normals for vertices whose file has none, as Unity's model importer derives them: faces that meet at an
// angle below 60 degrees are smoothed into each other, weighted by their angle at the vertex (Thuermer and
// Wuethrich 1998), so that the cut of a polygon into triangles does not show; sharper edges stay sharp.

// Fills every zero normal of a corner. Vertices that need one are split, one for each corner that uses them.
// No triangle may be without area. Normals point where counter-clockwise winding says outside is.
void add_missing_normals(ModelFile& model) {
  std::vector<Corner> corners = corners_without_normal(model);
  const auto place = [&](const Corner& corner) {
    const glm::dvec3& p = model.positions[model.indices[corner.index]];
    return std::tuple(p.x, p.y, p.z);
  };
  std::sort(corners.begin(), corners.end(), [&](const Corner& a, const Corner& b) {
    return std::tuple_cat(place(a), std::tuple(a.index)) < std::tuple_cat(place(b), std::tuple(b.index));
  });
  std::vector<glm::dvec3> normals(corners.size());
  for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
    while (end < corners.size() && place(corners[end]) == place(corners[begin])) ++end;
    const std::size_t hub = std::min(end - begin, kLargestHub);
    for (std::size_t i = begin; i < end; ++i) {
      normals[i] = smoothed(corners[i], corners.data() + begin, corners.data() + begin + hub);
    }
  }
  // Corners at one place with one normal and one place on the texture share a vertex.
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::uint32_t& index = model.indices[corners[i].index];
    const glm::dvec3 position = model.positions[index];
    const glm::dvec2 uv = model.uvs[index];
    const bool same = i > 0 && model.positions.back() == position && model.normals.back() == normals[i] &&
                      model.uvs.back() == uv;
    if (!same) {
      model.positions.push_back(position);
      model.normals.push_back(normals[i]);
      model.uvs.push_back(uv);
    }
    index = static_cast<std::uint32_t>(model.positions.size() - 1);
  }
}

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
