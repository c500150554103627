#include "resolve/frame_on_device.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <span>

#include "parameters/half_angle.h"

namespace penumbra::resolve {
namespace {

constexpr int kMaxCascades = 4;

enum class ProvidedSampler { compare, point, linear };

const std::map<std::string, ProvidedSampler> kSamplers{
    {"sampler_ShadowMap", ProvidedSampler::compare},
    {"sampler_MainLightShadowmapTexture", ProvidedSampler::compare},
    {"sampler_LinearClampCompare", ProvidedSampler::compare},
    {"sampler_PenumbraLinearClampCompare", ProvidedSampler::compare},
    {"sampler_PenumbraPointClamp", ProvidedSampler::point},
    {"sampler_PenumbraLinearClamp", ProvidedSampler::linear},
    {"sampler_PointClamp", ProvidedSampler::point},
    {"sampler_LinearClamp", ProvidedSampler::linear}};

gpu::Format gpu_format(scene::DepthFormat format) {
  switch (format) {
    case scene::DepthFormat::d16:
      return gpu::Format::depth16;
    case scene::DepthFormat::d24:
      return gpu::Format::depth24;
    case scene::DepthFormat::d32:
      break;
  }
  return gpu::Format::depth32;
}

// Beyond the last cascade URP keeps a matrix that sends everything past the far plane, so that a shader which
// picks no cascade reads "lit".
glm::dmat4 no_cascade_matrix(bool reversed_z) {
  glm::dmat4 matrix(0.0);
  matrix[3] = {0.0, 0.0, reversed_z ? 1.0 : 0.0, 1.0};
  return matrix;
}

// URP packs the half-texel offsets of its 4-tap kernel in two vectors.
std::array<glm::vec4, 2> four_tap_offsets(const parameters::CascadeSet& set) {
  const float x = 0.5f / static_cast<float>(set.atlas_width);
  const float y = 0.5f / static_cast<float>(set.atlas_height);
  return {glm::vec4(-x, -y, x, -y), glm::vec4(-x, y, x, y)};
}

glm::vec4 atlas_texel_size(const parameters::CascadeSet& set) {
  const auto width = static_cast<float>(set.atlas_width);
  const auto height = static_cast<float>(set.atlas_height);
  return {1.0f / width, 1.0f / height, width, height};
}

// Returns a sphere that holds no position: Unity's unused split spheres lie at the origin with a radius that
// no distance is below.
glm::vec4 unused_sphere() {
  return {0.0f, 0.0f, 0.0f, 0.0f};
}

UniformValues cascade_uniforms(const scene::Frame& frame) {
  const parameters::CascadeSet& set = frame.cascades;
  std::vector<glm::dmat4> matrices;
  std::vector<glm::vec4> spheres;
  std::vector<glm::vec4> tiles;
  std::vector<glm::vec4> scales;
  glm::vec4 squared_radii(0.0f);
  for (const parameters::Cascade& cascade : set.cascades) {
    matrices.push_back(cascade.world_to_shadow);
    squared_radii[cascade.index] = static_cast<float>(cascade.split_sphere.w * cascade.split_sphere.w);
    spheres.emplace_back(cascade.split_sphere);
    tiles.emplace_back(cascade.offset_scale);
    scales.emplace_back(cascade.uv_per_metre, cascade.depth_per_metre, cascade.depth_to_radial,
                        cascade.radial_to_depth.value_or(0.0));
  }
  while (matrices.size() < kMaxCascades + 1) matrices.push_back(no_cascade_matrix(set.reversed_z));
  while (spheres.size() < kMaxCascades) {
    spheres.push_back(unused_sphere());
    tiles.emplace_back(0.0f);
    scales.emplace_back(0.0f);
  }

  UniformValues values;
  values.set("_PenumbraCascadeCount", static_cast<int>(set.cascades.size()));
  values.set("_PenumbraTileOffsetScale", std::span<const glm::vec4>(tiles));
  values.set("_PenumbraTileScales", std::span<const glm::vec4>(scales));
  values.set("_PenumbraSplitSpheres", std::span<const glm::vec4>(spheres));
  values.set("_PenumbraSplitSphereSquaredRadii", squared_radii);
  values.set("_PenumbraAtlasTexelSize", atlas_texel_size(set));
  const scene::CascadeBlend& blend = frame.settings.cascade_choices.blend;
  values.set("_PenumbraCascadeBlend",
             glm::vec4(static_cast<float>(blend.border), blend.mixed ? 1.0f : 0.0f, 0.0f, 0.0f));
  values.set("_PenumbraWorldToShadow", std::span<const glm::dmat4>(matrices));

  values.set("_PenumbraMainLightAtlasTexelSize", atlas_texel_size(set));
  values.set("_MainLightWorldToShadow", std::span<const glm::dmat4>(matrices));
  for (int i = 0; i < kMaxCascades; ++i) {
    values.set("_CascadeShadowSplitSpheres" + std::to_string(i), spheres[static_cast<std::size_t>(i)]);
  }
  values.set("_CascadeShadowSplitSphereRadii", squared_radii);
  values.set("_MainLightShadowmapSize", atlas_texel_size(set));
  values.set("_MainLightShadowOffset0", four_tap_offsets(set)[0]);
  values.set("_MainLightShadowOffset1", four_tap_offsets(set)[1]);
  return values;
}

// The spot light's map is one tile. URP's main light has no map then, so its uniforms are not among these.
UniformValues spot_uniforms(const scene::Frame& frame) {
  const parameters::SpotShadow& spot = *frame.spot_shadow;
  std::vector<glm::dmat4> matrices{spot.world_to_shadow};
  while (matrices.size() < kMaxCascades + 1) matrices.push_back(no_cascade_matrix(spot.reversed_z));
  std::vector<glm::vec4> tiles{{0.0F, 0.0F, 1.0F, 1.0F}};
  tiles.resize(kMaxCascades, glm::vec4(0.0F));
  UniformValues values = cascade_uniforms(frame);
  values.set("_PenumbraWorldToShadow", std::span<const glm::dmat4>(matrices));
  values.set("_PenumbraTileOffsetScale", std::span<const glm::vec4>(tiles));
  values.set("_PenumbraSpotLight",
             glm::vec4(glm::dvec4(spot.light.shadow_near_plane_metres, spot.light.range_metres,
                                  0.5 / spot.uv_per_tangent, spot.light.source_radius_metres)));
  return values;
}

// The light has strength 1, the soft quality of the settings, and a distance fade that has not begun
// anywhere.
void add_light_uniforms(const scene::Frame& frame, UniformValues& values) {
  const auto quality = static_cast<float>(frame.settings.shadows.soft_quality);
  values.set("_MainLightShadowParams", glm::vec4(1.0f, quality, 0.0f, 0.0f));
  values.set("_MainLightPosition", glm::vec4(glm::vec3(-frame.cascades.light_direction), 0.0f));
  // This vector points towards the sun in world space, with unit length; w is half the sun's angular diameter
  // in radians.
  values.set("_PenumbraTowardSun",
             glm::vec4(glm::vec3(-frame.cascades.light_direction),
                       static_cast<float>(glm::radians(0.5 * frame.cascades.angular_diameter_degrees))));
  values.set("_PenumbraCloudWind", glm::vec4(0.0f));
  values.set("_PenumbraShadowDistance",
             glm::vec4(static_cast<float>(frame.settings.shadows.distance_metres), 0.0f, 0.0f, 0.0f));
  values.set("_MainLightColor", glm::vec4(1.0f));
  // URP passes its mip bias and its power of two; there is no bias here.
  values.set("_GlobalMipBias", glm::vec4(0.0f, 1.0f, 0.0f, 0.0f));
  values.set("_WorldSpaceCameraPos", glm::vec4(glm::vec3(frame.camera.position), 0.0f));
  values.set("_PenumbraCloudCentre", glm::vec4(glm::vec3(frame.camera.position), 0.0f));
  values.set("_PenumbraCloudWind", glm::vec4(0.0f));
  const auto width = static_cast<float>(frame.receivers.width);
  const auto height = static_cast<float>(frame.receivers.height);
  values.set("_ScreenParams", glm::vec4(width, height, 1.0f + 1.0f / width, 1.0f + 1.0f / height));
}

// Techniques without a shadow map read these: the plane of the ground, and the balls that stand for objects.
void add_stand_ins(const scene::Frame& frame, UniformValues& values) {
  values.set("_PenumbraPlane", glm::vec4(0.0F, 1.0F, 0.0F, static_cast<float>(frame.ground_metres)));
  std::vector<glm::vec4> balls(scene::kMostBalls, glm::vec4(0.0F));
  for (std::size_t i = 0; i < frame.balls.size(); ++i)
    balls.at(i) = glm::vec4(glm::dvec4(frame.balls[i].centre, frame.balls[i].radius));
  values.set("_PenumbraBalls", std::span<const glm::vec4>(balls));
  values.set("_PenumbraBallCount", static_cast<int>(frame.balls.size()));
}

MapLayout layout_of(const scene::Frame& frame) {
  const parameters::CascadeSet& set = frame.cascades;
  MapLayout layout{frame.atlas.width, frame.atlas.height, set.tile_resolution, {}};
  for (const parameters::Cascade& cascade : set.cascades)
    layout.origins.push_back({static_cast<int>(std::lround(cascade.offset_scale.x * frame.atlas.width)),
                              static_cast<int>(std::lround(cascade.offset_scale.y * frame.atlas.height))});
  return layout;
}

// Returns the matrix from UV and stored depth, homogeneous, to clip space whose y = -1 is the first row.
glm::dmat4 clip_from_uv(double offset_x, double offset_y, double scale_x, double scale_y) {
  glm::dmat4 matrix(1.0);
  matrix[0][0] = 2.0 / scale_x;
  matrix[1][1] = 2.0 / scale_y;
  matrix[3][0] = -2.0 * offset_x / scale_x - 1.0;
  matrix[3][1] = -2.0 * offset_y / scale_y - 1.0;
  return matrix;
}

// The package's own shaders dither: they have no border between cascades where the frame asks for a mixture.
glm::vec4 main_light_params(const scene::Frame& frame) {
  const parameters::CascadeSet& set = frame.cascades;
  const scene::CascadeBlend& blend = frame.settings.cascade_choices.blend;
  const double tan_half = parameters::tan_half(set.angular_diameter_degrees);
  return {static_cast<float>(set.cascades.size()), static_cast<float>(tan_half), 0.0f,
          blend.mixed ? 0.0f : static_cast<float>(blend.border)};
}

}  // namespace

FrameOnDevice::FrameOnDevice(const gpu::Device& device, const scene::Frame& frame,
                             const CastersOnDevice* casters, const FrameInputs* inputs)
    : casters_(casters),
      inputs_(inputs),
      cascades_(frame.cascades),
      width_(frame.receivers.width),
      height_(frame.receivers.height),
      map_layout_(layout_of(frame)),
      atlas_(device, gpu_format(frame.atlas.format), frame.atlas.width, frame.atlas.height),
      compare_(device, frame.cascades.reversed_z ? gpu::SamplerKind::compare_greater_equal
                                                 : gpu::SamplerKind::compare_less_equal),
      point_(device, gpu::SamplerKind::point_clamp),
      linear_(device, gpu::SamplerKind::linear_clamp),
      positions_(device, std::span<const glm::vec4>(frame.receivers.position_ws)),
      normals_(device, std::span<const glm::vec4>(frame.receivers.normal_ws)),
      visibility_(device, frame.receivers.position_ws.size() * sizeof(float)),
      uniforms_(frame.spot_shadow ? spot_uniforms(frame) : cascade_uniforms(frame)),
      main_light_params_(main_light_params(frame)) {
  atlas_.upload_bytes(frame.atlas.texels);
  add_light_uniforms(frame, uniforms_);
  add_stand_ins(frame, uniforms_);
  uniforms_.set_integers("_PenumbraImageSize", {width_, height_, 0, 0});
}

UniformValues FrameOnDevice::uniforms(int noise_frame) const {
  UniformValues values = uniforms_;
  values.set("_PenumbraNoiseFrame", noise_frame);
  glm::vec4 params = main_light_params_;
  params.z = static_cast<float>(noise_frame);
  values.set("_PenumbraMainLightParams", params);
  if (inputs_ != nullptr) values.merge(inputs_->uniforms);
  return values;
}

UniformValues FrameOnDevice::caster_uniforms(int index) const {
  const parameters::Cascade& cascade = cascades_.cascades.at(static_cast<std::size_t>(index));
  const glm::dvec4& tile = cascade.offset_scale;
  const std::array to_clip{clip_from_uv(tile.x, tile.y, tile.z, tile.w) * cascade.world_to_shadow};
  UniformValues values;
  values.set("unity_MatrixVP", std::span<const glm::dmat4>(to_clip));
  values.set("_ShadowBias", glm::vec4(static_cast<float>(cascade.depth_bias_metres),
                                      static_cast<float>(cascade.normal_bias_metres), 0.0F, 0.0F));
  values.set("_LightDirection", glm::vec4(glm::vec3(-cascades_.light_direction), 0.0F));
  return values;
}

UniformValues FrameOnDevice::caster_uniforms(const CameraImage& camera) {
  const std::array to_clip{clip_from_uv(0.0, 0.0, 1.0, 1.0) * glm::inverse(camera.screen_to_world)};
  UniformValues values;
  values.set("unity_MatrixVP", std::span<const glm::dmat4>(to_clip));
  return values;
}

std::map<std::string, const gpu::Buffer*> FrameOnDevice::buffers() const {
  return {{"_PenumbraReceiverPositionWS", &positions_},
          {"_PenumbraReceiverNormalWS", &normals_},
          {"_PenumbraVisibility", &visibility_}};
}

std::map<std::string, const gpu::Image*> FrameOnDevice::images() const {
  std::map<std::string, const gpu::Image*> images{{"_ShadowMap", &atlas_},
                                                  {"_MainLightShadowmapTexture", &atlas_}};
  if (inputs_ != nullptr)
    for (const auto& [name, image] : inputs_->images) images[name] = &image;
  return images;
}

std::map<std::string, const gpu::Sampler*> FrameOnDevice::samplers() const {
  const std::map<ProvidedSampler, const gpu::Sampler*> of_kind{{ProvidedSampler::compare, &compare_},
                                                               {ProvidedSampler::point, &point_},
                                                               {ProvidedSampler::linear, &linear_}};
  std::map<std::string, const gpu::Sampler*> samplers;
  for (const auto& [name, kind] : kSamplers) samplers[name] = of_kind.at(kind);
  return samplers;
}

std::optional<bool> FrameOnDevice::sampler_compares(const std::string& name) {
  const auto found = kSamplers.find(name);
  if (found == kSamplers.end()) return std::nullopt;
  return found->second == ProvidedSampler::compare;
}

}  // namespace penumbra::resolve
