#include "scene/seen_surfaces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "parameters/half_angle.h"
#include "scene/scene_shader.h"

namespace penumbra::scene {
namespace {

// SeenSurface.hlsl adds it to the triangle's number.
constexpr std::uint32_t first_triangle_bits = 0x4000'0000U;

// The uniforms CameraView of SeenSurface.hlsl.
struct CameraView {
  glm::vec4 view_row[3];
  glm::vec4 near_plane;
};

glm::vec4 row(const glm::dvec3& axis, const glm::dvec3& eye) {
  return {axis, -glm::dot(axis, eye)};
}

// Unity's world is left-handed: right = up x forward.
CameraView view_of(const parameters::Camera& camera, const glm::dvec2& lens_shift) {
  const glm::dvec3 forward = glm::normalize(camera.forward);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, forward));
  const glm::dvec3 up = glm::cross(forward, right);
  const double tan_half = parameters::tan_half(camera.fov_y_degrees);
  return {{row(right / (tan_half * camera.aspect) - forward * lens_shift.x, camera.position),
           row(forward * lens_shift.y - up / tan_half, camera.position), row(forward, camera.position)},
          glm::vec4(float(camera.near_plane), 0.0F, 0.0F, 0.0F)};
}

struct Surface {
  std::size_t triangle;
  glm::dvec3 position;
  glm::dvec3 normal;
};

// The interpolated point is moved onto its triangle's plane along the plane's normal: interpolation errs by
// far more than a float's rounding, and an error along the normal would be a false shadow.
std::optional<Surface> surface_at(const Mesh& mesh, const glm::dvec3& eye, const glm::vec4& texel) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(texel.w);
  if (bits < first_triangle_bits) return std::nullopt;
  const std::size_t triangle = bits - first_triangle_bits;
  const glm::dvec3 a(mesh.positions[mesh.indices[3 * triangle]]);
  const glm::dvec3 b(mesh.positions[mesh.indices[3 * triangle + 1]]);
  const glm::dvec3 c(mesh.positions[mesh.indices[3 * triangle + 2]]);
  const glm::dvec3 across = glm::cross(b - a, c - a);
  const double length = glm::length(across);
  if (!(length > 0.0)) return std::nullopt;
  const glm::dvec3 normal = across / length;
  const glm::dvec3 seen(texel);
  const glm::dvec3 position = seen - normal * glm::dot(normal, seen - a);
  return Surface{triangle, position, glm::dot(normal, eye - position) < 0.0 ? -normal : normal};
}

Receivers receivers_of(const Scene& scene, const FrameSettings& settings,
                       const std::vector<glm::vec4>& texels) {
  Receivers receivers;
  receivers.width = settings.width;
  receivers.height = settings.height;
  receivers.position_ws.resize(texels.size(), glm::vec4(0.0F));
  receivers.position_relative.resize(texels.size(), glm::vec4(0.0F));
  receivers.normal_ws.resize(texels.size(), glm::vec4(0.0F));
  receivers.triangle.resize(texels.size(), no_triangle);
  const double farthest = std::min(std::max(settings.shadows.distance_metres, scene.seen_distance_metres),
                                   scene.camera.far_plane);
  for (std::size_t pixel = 0; pixel < texels.size(); ++pixel) {
    const std::optional<Surface> surface = surface_at(scene.mesh, scene.camera.position, texels[pixel]);
    if (!surface) continue;
    receivers.triangle[pixel] = static_cast<std::uint32_t>(surface->triangle);
    if (glm::distance(surface->position, scene.camera.position) > farthest) continue;
    receivers.position_ws[pixel] = glm::vec4(glm::vec3(scene.origin + surface->position), 1.0F);
    receivers.position_relative[pixel] = glm::vec4(glm::vec3(surface->position), 1.0F);
    receivers.normal_ws[pixel] = glm::vec4(glm::vec3(surface->normal), 0.0F);
  }
  return receivers;
}

gpu::RasterShaders shaders_of_pass(bool cut_outs) {
  gpu::RasterShaders shaders;
  shaders.vertex = compile_scene_shader({"SeenSurface.hlsl", "Vertex", hlsl::Stage::vertex, true, cut_outs});
  shaders.fragment =
      compile_scene_shader({"SeenSurface.hlsl", "Fragment", hlsl::Stage::fragment, true, cut_outs});
  shaders.vertex_entry = "Vertex";
  shaders.fragment_entry = "Fragment";
  shaders.colours = {gpu::Format::rgba32f};
  shaders.depth = gpu::Format::depth32;
  shaders.depth_test = gpu::DepthTest::greater;
  return shaders;
}

}  // namespace

Receivers SeenSurfacesPass::draw(const Scene& scene, const FrameSettings& settings) {
  if (!pass_) {
    pass_.emplace(device_, shaders_of_pass(mesh_.cut_outs.has_value()));
    mesh_.bind_to(pass_->bindings());
  }
  const gpu::Image seen(device_, gpu::Format::rgba32f, settings.width, settings.height);
  const gpu::Image depth(device_, gpu::Format::depth32, settings.width, settings.height);
  const CameraView view = view_of(scene.camera, settings.lens_shift);
  gpu::RasterTile whole{0, 0, settings.width, settings.height, mesh_.vertex_count, {}};
  whole.push_constants.resize(sizeof(view));
  std::memcpy(whole.push_constants.data(), &view, sizeof(view));
  pass_->draw({{&seen}, &depth, 0.0F}, {whole});
  return receivers_of(scene, settings, seen.download<glm::vec4>());
}

}  // namespace penumbra::scene
