#include "scene/frame.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <tuple>

#include "gpu/raster_pass.h"
#include "input/input_error.h"
#include "parameters/half_angle.h"
#include "scene/mesh_on_device.h"

namespace penumbra::scene {

// The passes by format, reversed Z, and the rasteriser's constant and slope bias. Each is made when first
// needed.
class ShadowMapPasses {
 public:
  ShadowMapPasses(const gpu::Device& device, const MeshOnDevice& mesh) : device_(device), mesh_(mesh) {}

  // `origin` is the world position of the mesh's own origin.
  ShadowAtlas draw(const parameters::CascadeSet& cascades, const glm::dvec3& origin,
                   const FrameSettings& settings);

 private:
  using Key = std::tuple<DepthFormat, bool, double, double>;

  gpu::RasterPass& pass(const Key& key);

  const gpu::Device& device_;
  const MeshOnDevice& mesh_;
  std::map<Key, gpu::RasterPass> passes_;
};

// Draws the surfaces that the camera sees and turns them into receivers.
class SeenSurfacesPass {
 public:
  SeenSurfacesPass(const gpu::Device& device, const MeshOnDevice& mesh) : device_(device), mesh_(mesh) {}

  // `scene` must be the one that the mesh was made from.
  Receivers draw(const Scene& scene, const FrameSettings& settings);

 private:
  const gpu::Device& device_;
  const MeshOnDevice& mesh_;
  std::optional<gpu::RasterPass> pass_;
};

namespace {

// The uniforms CasterTile of ShadowCaster.hlsl.
struct CasterTile {
  glm::vec4 shadow_row[3];
  glm::vec4 toward_light;
  glm::vec4 bias;
};

gpu::Format gpu_format(DepthFormat format) {
  if (format == DepthFormat::d16) return gpu::Format::depth16;
  return format == DepthFormat::d24 ? gpu::Format::depth24 : gpu::Format::depth32;
}

// Returns a row of the matrix for positions relative to `origin`, in double until it is stored.
glm::dvec4 row_from_origin(const glm::dmat4& matrix, int row, const glm::dvec3& origin) {
  return {matrix[0][row], matrix[1][row], matrix[2][row], (matrix * glm::dvec4(origin, 1.0))[row]};
}

// Maps atlas UV to the tile's clip space, whose y = -1 is the tile's first row, as v grows with the row.
glm::vec4 clip_row(const glm::dvec4& uv_row, double offset, double scale) {
  glm::dvec4 row = uv_row * (2.0 / scale);
  row.w -= 2.0 * offset / scale + 1.0;
  return glm::vec4(row);
}

gpu::RasterTile tile_of(const parameters::CascadeSet& set, const parameters::Cascade& cascade,
                        const glm::dvec3& origin, std::uint32_t vertex_count) {
  const glm::dmat4& matrix = cascade.world_to_shadow;
  const glm::dvec4& place = cascade.offset_scale;
  CasterTile constants;
  constants.shadow_row[0] = clip_row(row_from_origin(matrix, 0, origin), place.x, place.z);
  constants.shadow_row[1] = clip_row(row_from_origin(matrix, 1, origin), place.y, place.w);
  constants.shadow_row[2] = glm::vec4(row_from_origin(matrix, 2, origin));
  constants.toward_light = glm::vec4(glm::vec3(-set.light_direction), 0.0F);
  constants.bias = {float(cascade.depth_bias_metres), float(cascade.normal_bias_metres), 0.0F, 0.0F};

  gpu::RasterTile tile;
  tile.x = static_cast<int>(std::lround(place.x * set.atlas_width));
  tile.y = static_cast<int>(std::lround(place.y * set.atlas_height));
  tile.width = tile.height = set.tile_resolution;
  tile.vertex_count = vertex_count;
  tile.push_constants.resize(sizeof(constants));
  std::memcpy(tile.push_constants.data(), &constants, sizeof(constants));
  return tile;
}

// Returns the texel's number as the sampler returns it: unorm formats divide by their largest integer.
float decode(DepthFormat format, const std::byte* texel) {
  if (format == DepthFormat::d16) {
    std::uint16_t stored = 0;
    std::memcpy(&stored, texel, sizeof(stored));
    return float(stored) / 65535.0F;
  }
  if (format == DepthFormat::d24) {
    std::uint32_t stored = 0;
    std::memcpy(&stored, texel, sizeof(stored));
    return static_cast<float>(double(stored & 0xFF'FFFFU) / 16777215.0);
  }
  float stored = 0.0F;
  std::memcpy(&stored, texel, sizeof(stored));
  return stored;
}

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

const Mesh& checked(const Scene& scene) {
  const Mesh& mesh = scene.mesh;
  if (mesh.indices.empty() || mesh.indices.size() % 3 != 0) {
    throw InputError("", "scene '" + scene.name + "' has no triangles, or part of one");
  }
  if (mesh.normals.size() != mesh.positions.size()) {
    throw InputError("", "scene '" + scene.name + "' does not have one normal per position");
  }
  for (const std::uint32_t index : mesh.indices) {
    if (index < mesh.positions.size()) continue;
    throw InputError("", "scene '" + scene.name + "': index " + std::to_string(index) + " of " +
                             std::to_string(mesh.positions.size()) + " vertices");
  }
  return mesh;
}

void check(const FrameSettings& settings) {
  if (settings.width > 0 && settings.height > 0) return;
  throw InputError(
      "",
      "a picture of " + std::to_string(settings.width) + " x " + std::to_string(settings.height) + " pixels",
      "width and height are at least 1");
}

parameters::ShadowSettings with_caster_bounds(parameters::ShadowSettings shadows, const Scene& scene) {
  if (shadows.depth_range_metres || shadows.caster_bounds) return shadows;
  const parameters::Bounds bounds = scene.bounds();
  shadows.caster_bounds = parameters::Bounds{bounds.minimum + scene.origin, bounds.maximum + scene.origin};
  return shadows;
}

// Returns the positions of the pixels that show a surface within the shadow distance.
std::vector<glm::dvec3> seen_positions(const Receivers& receivers, const Scene& scene,
                                       double shadow_distance) {
  std::vector<glm::dvec3> positions;
  for (std::size_t i = 0; i < receivers.position_ws.size(); ++i) {
    const glm::dvec3 position(receivers.position_relative[i]);
    if (receivers.position_ws[i].w != 0.0F &&
        glm::distance(position, scene.camera.position) <= shadow_distance)
      positions.push_back(scene.origin + position);
  }
  return positions;
}

}  // namespace

gpu::RasterPass& ShadowMapPasses::pass(const Key& key) {
  const auto found = passes_.find(key);
  if (found != passes_.end()) return found->second;
  const auto [format, reversed_z, constant_bias, slope_bias] = key;
  const float away_from_light = reversed_z ? -1.0F : 1.0F;
  gpu::RasterShaders shaders;
  SceneShader shader{"ShadowCaster.hlsl", "Main", hlsl::Stage::vertex, reversed_z,
                     mesh_.cut_outs.has_value()};
  shaders.vertex = compile_scene_shader(shader);
  if (shader.cut_outs) {
    shader.entry = shaders.fragment_entry = "Fragment";
    shader.stage = hlsl::Stage::fragment;
    shaders.fragment = compile_scene_shader(shader);
  }
  shaders.depth = gpu_format(format);
  shaders.depth_test = reversed_z ? gpu::DepthTest::greater : gpu::DepthTest::less;
  shaders.constant_depth_bias = away_from_light * static_cast<float>(constant_bias);
  shaders.slope_depth_bias = away_from_light * static_cast<float>(slope_bias);
  gpu::RasterPass made(device_, shaders);
  mesh_.bind_to(made.bindings());
  return passes_.emplace(key, std::move(made)).first->second;
}

ShadowAtlas ShadowMapPasses::draw(const parameters::CascadeSet& cascades, const glm::dvec3& origin,
                                  const FrameSettings& settings) {
  std::vector<gpu::RasterTile> tiles;
  for (const parameters::Cascade& cascade : cascades.cascades) {
    tiles.push_back(tile_of(cascades, cascade, origin, mesh_.vertex_count));
  }
  const DepthFormat format = settings.format;
  const gpu::Image image(device_, gpu_format(format), cascades.atlas_width, cascades.atlas_height);
  gpu::RasterTargets targets;
  targets.depth = &image;
  targets.clear_depth = cascades.reversed_z ? 0.0F : 1.0F;
  const RasterBias& bias = settings.raster_bias;
  pass({format, cascades.reversed_z, bias.constant, bias.slope}).draw(targets, tiles);

  ShadowAtlas atlas;
  atlas.width = cascades.atlas_width;
  atlas.height = cascades.atlas_height;
  atlas.format = format;
  atlas.texels = image.download<std::byte>();
  const std::size_t stride = gpu::texel_bytes(image.format());
  atlas.depth.resize(atlas.texels.size() / stride);
  for (std::size_t texel = 0; texel < atlas.depth.size(); ++texel) {
    atlas.depth[texel] = decode(format, &atlas.texels[texel * stride]);
  }
  return atlas;
}

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
struct Rasteriser::State {
  State(gpu::Device& device, const Scene& given)
      : scene(given),
        mesh(device, checked(given), CutOuts(given)),
        shadow_map(device, mesh),
        seen(device, mesh),
        ground_metres(ground_level(given.mesh) + given.origin.y),
        balls(object_balls(given.mesh, kMostBalls)) {
    for (Ball& ball : balls) ball.centre += given.origin;
  }

  const Scene& scene;
  MeshOnDevice mesh;
  ShadowMapPasses shadow_map;
  SeenSurfacesPass seen;
  double ground_metres;
  std::vector<Ball> balls;
};

Rasteriser::Rasteriser(gpu::Device& device, const Scene& scene)
    : state_(std::make_unique<State>(device, scene)) {}
Rasteriser::~Rasteriser() = default;
Rasteriser::Rasteriser(Rasteriser&&) noexcept = default;

Frame Rasteriser::frame(const FrameSettings& settings) {
  check(settings);
  const Scene& scene = state_->scene;
  Frame frame;
  frame.scene_name = scene.name;
  frame.settings = settings;
  frame.camera = scene.camera;
  frame.camera.position += scene.origin;
  frame.receivers = state_->seen.draw(scene, settings);
  frame.ground_metres = state_->ground_metres;
  frame.balls = state_->balls;
  const CascadeChoices& choices = settings.cascade_choices;
  const parameters::Light light{sun_before(scene.light_direction, choices.map_age_degrees),
                                settings.angular_diameter_degrees};
  frame.cascades = parameters::fit_cascades(
      frame.camera, light, with_caster_bounds(settings.shadows, scene), choices.light_fit,
      seen_positions(frame.receivers, scene, settings.shadows.distance_metres));
  frame.atlas = state_->shadow_map.draw(frame.cascades, scene.origin, settings);
  return frame;
}

Frame rasterise(gpu::Device& device, const Scene& scene, const FrameSettings& settings) {
  return Rasteriser(device, scene).frame(settings);
}

}  // namespace penumbra::scene
