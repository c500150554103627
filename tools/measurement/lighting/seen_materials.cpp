#include "lighting/seen_materials.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <utility>

#include "input/input_error.h"
#include "lighting/texture_pyramid.h"
#include "parameters/half_angle.h"

namespace penumbra::lighting {
namespace {

void check(const scene::Scene& scene) {
  const scene::Mesh& mesh = scene.mesh;
  const std::string name = "scene '" + scene.name + "': ";
  if (scene.materials.empty()) throw InputError("", name + "no material");
  if (!mesh.uvs.empty() && mesh.uvs.size() != mesh.positions.size()) {
    throw InputError("", name + "must have one texture coordinate per vertex");
  }
  if (!mesh.triangle_materials.empty() && mesh.triangle_materials.size() != mesh.triangle_count()) {
    throw InputError("", name + "must have one material per triangle");
  }
  for (const std::uint16_t material : mesh.triangle_materials) {
    if (material >= scene.materials.size())
      throw InputError("", name + "has a triangle with a material index out of range");
  }
  const int textures = static_cast<int>(scene.textures.size());
  for (const scene::Material& material : scene.materials) {
    if (material.base_colour_texture >= textures || material.normal_texture >= textures) {
      throw InputError("",
                       name + "material '" + material.name + "' refers to a texture that the scene lacks");
    }
  }
}

glm::vec3 unit_range(const glm::vec3& colour) {
  return glm::clamp(colour, glm::vec3(0.0F), glm::vec3(1.0F));
}

// The textures that materials read, each with its meaning. Each pyramid is built once.
class Pyramids {
 public:
  explicit Pyramids(const scene::Scene& scene) {
    for (const scene::Material& material : scene.materials) {
      make(scene, material.base_colour_texture, TexelMeaning::srgb_colour);
      make(scene, material.normal_texture, TexelMeaning::vector);
    }
  }

  const TexturePyramid* find(int texture, TexelMeaning meaning) const {
    const auto found = pyramids_.find({texture, meaning});
    return found == pyramids_.end() ? nullptr : &found->second;
  }

 private:
  void make(const scene::Scene& scene, int texture, TexelMeaning meaning) {
    if (texture < 0 || pyramids_.contains({texture, meaning})) return;
    pyramids_.try_emplace({texture, meaning}, scene.textures[static_cast<std::size_t>(texture)], meaning);
  }

  std::map<std::pair<int, TexelMeaning>, TexturePyramid> pyramids_;
};

// Unity's world is left-handed: right = up x forward.
class PixelRays {
 public:
  PixelRays(const parameters::Camera& camera, const scene::FrameSettings& settings)
      : width_(settings.width), height_(settings.height) {
    forward_ = glm::normalize(camera.forward);
    const glm::dvec3 right = glm::normalize(glm::cross(camera.up, forward_));
    const double tan_half = parameters::tan_half(camera.fov_y_degrees);
    right_ = right * (tan_half * camera.aspect);
    up_ = glm::cross(forward_, right) * tan_half;
    shift_ = settings.lens_shift;
    spread_ = 2.0 * tan_half / settings.height;
  }

  glm::dvec3 direction(int column, int row) const {
    const double x = (column + 0.5) / width_ * 2.0 - 1.0 + shift_.x;
    const double y = 1.0 - (row + 0.5) / height_ * 2.0 + shift_.y;
    return glm::normalize(forward_ + right_ * x + up_ * y);
  }
  double spread() const { return spread_; }  // metres that a pixel covers one metre ahead

 private:
  int width_;
  int height_;
  glm::dvec3 forward_, right_, up_;
  glm::dvec2 shift_{0.0};
  double spread_ = 0.0;
};

struct Corners {
  std::uint32_t index[3];
  glm::dvec3 position[3];
};

Corners corners_of(const scene::Mesh& mesh, std::size_t triangle) {
  Corners corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    corners.index[k] = mesh.indices[3 * triangle + k];
    corners.position[k] = glm::dvec3(mesh.positions[corners.index[k]]);
  }
  return corners;
}

// Returns the shares of the corners at a point of their plane; a pixel at an edge may lie a little outside.
glm::dvec3 barycentric(const Corners& corners, const glm::dvec3& across, const glm::dvec3& point) {
  const double area2 = glm::dot(across, across);
  const auto share = [&](int from, int to) {
    const glm::dvec3 edge = corners.position[to] - corners.position[from];
    return glm::dot(glm::cross(edge, point - corners.position[from]), across) / area2;
  };
  const glm::dvec3 shares = glm::clamp(glm::dvec3(share(1, 2), share(2, 0), share(0, 1)), 0.0, 1.0);
  return shares / (shares.x + shares.y + shares.z);
}

class MaterialReader {
 public:
  MaterialReader(const scene::Scene& scene, const scene::Frame& frame)
      : scene_(scene), rays_(scene.camera, frame.settings), pyramids_(scene) {}

  glm::dvec3 direction(int column, int row) const { return rays_.direction(column, row); }

  SurfacePoint read(std::size_t triangle, const glm::dvec3& direction) const {
    const scene::Mesh& mesh = scene_.mesh;
    const Corners corners = corners_of(mesh, triangle);
    const glm::dvec3 across =
        glm::cross(corners.position[1] - corners.position[0], corners.position[2] - corners.position[0]);
    const glm::dvec3& eye = scene_.camera.position;
    const double away = glm::dot(across, direction);
    const double distance = glm::dot(across, corners.position[0] - eye) / away;
    const glm::dvec3 shares = barycentric(corners, across, eye + direction * distance);

    SurfacePoint point;
    point.position = glm::vec3(corners.position[0] * shares.x + corners.position[1] * shares.y +
                               corners.position[2] * shares.z);
    const glm::dvec3 flat = glm::normalize(away > 0.0 ? -across : across);
    point.flat_normal = glm::vec3(flat);
    const scene::Material& material = scene_.materials[mesh.material_of(triangle)];
    point.roughness = std::clamp(material.roughness, 0.0F, 1.0F);
    point.translucency = std::clamp(material.translucency, 0.0F, 1.0F);
    point.base_colour = unit_range(material.base_colour);
    glm::dvec3 normal(0.0);
    for (int k = 0; k < 3; ++k) normal += shares[k] * glm::dvec3(mesh.normals[corners.index[k]]);
    normal = glm::dot(normal, flat) > 0.0 ? glm::normalize(normal) : -glm::normalize(normal);
    if (!(std::abs(glm::length(normal) - 1.0) < 1e-3)) normal = flat;  // the corners' normals may cancel out
    point.normal = glm::vec3(normal);
    const double cosine = std::max(std::abs(away) / glm::length(across), 1e-3);
    if (!mesh.uvs.empty())
      read_textures(corners, shares, across, distance * rays_.spread() / std::sqrt(cosine), point, material);
    return point;
  }

 private:
  void read_textures(const Corners& corners, const glm::dvec3& shares, const glm::dvec3& across,
                     double footprint_metres, SurfacePoint& point, const scene::Material& material) const {
    const glm::dvec2 a(scene_.mesh.uvs[corners.index[0]]);
    const glm::dvec2 b(scene_.mesh.uvs[corners.index[1]]);
    const glm::dvec2 c(scene_.mesh.uvs[corners.index[2]]);
    const glm::vec2 uv(a * shares.x + b * shares.y + c * shares.z);
    const double uv_area = (b - a).x * (c - a).y - (b - a).y * (c - a).x;
    const auto footprint =
        static_cast<float>(footprint_metres * std::sqrt(std::abs(uv_area) / glm::length(across)));
    if (const TexturePyramid* colours =
            pyramids_.find(material.base_colour_texture, TexelMeaning::srgb_colour)) {
      point.base_colour = unit_range(point.base_colour * colours->read(uv, footprint));
    }
    const TexturePyramid* normals = pyramids_.find(material.normal_texture, TexelMeaning::vector);
    if (normals == nullptr || uv_area == 0.0) return;
    // These are the directions in which u increases and v decreases on the triangle.
    const glm::dvec3 ab = corners.position[1] - corners.position[0];
    const glm::dvec3 ac = corners.position[2] - corners.position[0];
    const glm::dvec3 along_u = (ab * (c - a).y - ac * (b - a).y) / uv_area;
    const glm::dvec3 against_v = (ab * (c - a).x - ac * (b - a).x) / uv_area;
    point.normal = bent(point, along_u, against_v, glm::dvec3(normals->read(uv, footprint)));
  }

  // If the normal map bends the normal below the surface, it is kept on the flat normal's side.
  static glm::vec3 bent(const SurfacePoint& point, const glm::dvec3& along_u, const glm::dvec3& against_v,
                        const glm::dvec3& map) {
    const glm::dvec3 normal(point.normal);
    const glm::dvec3 tangent = glm::normalize(along_u - normal * glm::dot(normal, along_u));
    const glm::dvec3 bitangent = glm::normalize(against_v - normal * glm::dot(normal, against_v));
    const glm::dvec3 result = glm::normalize(tangent * map.x + bitangent * map.y + normal * map.z);
    const bool usable = std::isfinite(result.x) && glm::dot(result, glm::dvec3(point.flat_normal)) > 0.0;
    return usable ? glm::vec3(result) : point.normal;
  }

  const scene::Scene& scene_;
  PixelRays rays_;
  Pyramids pyramids_;
};

}  // namespace

SeenMaterials seen_materials(const scene::Scene& scene, const scene::Frame& frame) {
  check(scene);
  SeenMaterials seen;
  seen.width = frame.settings.width;
  seen.height = frame.settings.height;
  const std::size_t pixels = static_cast<std::size_t>(seen.width) * static_cast<std::size_t>(seen.height);
  if (frame.receivers.triangle.size() != pixels) {
    throw InputError("", "the frame does not say which triangle each pixel shows");
  }
  seen.seen.resize(pixels);
  seen.points.resize(pixels);
  seen.view_direction.resize(pixels);
  const MaterialReader reader(scene, frame);
  reference::for_each_row(seen.height, {}, [&](int row) {
    for (int column = 0; column < seen.width; ++column) {
      const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(seen.width) +
                                static_cast<std::size_t>(column);
      const glm::dvec3 direction = reader.direction(column, row);
      seen.view_direction[pixel] = glm::vec3(direction);
      const std::uint32_t triangle = frame.receivers.triangle[pixel];
      if (triangle == scene::no_triangle) continue;
      seen.seen[pixel] = 1;
      seen.points[pixel] = reader.read(triangle, direction);
    }
  });
  return seen;
}

std::vector<glm::vec3> mean_colours(const scene::Scene& scene) {
  check(scene);
  const Pyramids pyramids(scene);
  std::vector<glm::vec3> colours;
  for (const scene::Material& material : scene.materials) {
    const TexturePyramid* texture = pyramids.find(material.base_colour_texture, TexelMeaning::srgb_colour);
    const bool textured = texture != nullptr && !scene.mesh.uvs.empty();
    colours.push_back(unit_range(material.base_colour * (textured ? texture->mean() : glm::vec3(1.0F))));
  }
  return colours;
}

}  // namespace penumbra::lighting
