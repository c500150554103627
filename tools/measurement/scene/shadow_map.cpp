#include "scene/shadow_map.h"

#include <cmath>
#include <cstring>

#include "scene/scene_shader.h"

namespace penumbra::scene {
namespace {

// The uniforms CasterTile of ShadowCaster.hlsl.
struct CasterTile {
  glm::vec4 shadow_row[3];
  glm::vec4 toward_light;
  glm::vec4 bias;
};

// The same uniforms with PENUMBRA_SPOT_LIGHT.
struct SpotTile {
  glm::vec4 shadow_row[4];
  glm::vec4 light_position;
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

template <typename Constants>
std::vector<std::byte> bytes_of(const Constants& constants) {
  std::vector<std::byte> bytes(sizeof(constants));
  std::memcpy(bytes.data(), &constants, sizeof(constants));
  return bytes;
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
  tile.push_constants = bytes_of(constants);
  return tile;
}

// The rows map UV times w to clip space: 2 uv - 1, times w.
gpu::RasterTile tile_of(const parameters::SpotShadow& spot, const glm::dvec3& origin,
                        std::uint32_t vertex_count) {
  glm::dvec4 rows[4];
  for (int row = 0; row < 4; ++row) rows[row] = row_from_origin(spot.world_to_shadow, row, origin);
  SpotTile constants;
  constants.shadow_row[0] = glm::vec4(2.0 * rows[0] - rows[3]);
  constants.shadow_row[1] = glm::vec4(2.0 * rows[1] - rows[3]);
  constants.shadow_row[2] = glm::vec4(rows[2]);
  constants.shadow_row[3] = glm::vec4(rows[3]);
  constants.light_position = glm::vec4(glm::vec3(spot.light.position - origin), 0.0F);
  constants.bias = {float(spot.depth_bias_metres), float(spot.normal_bias_metres), 0.0F, 0.0F};

  gpu::RasterTile tile;
  tile.width = tile.height = spot.resolution;
  tile.vertex_count = vertex_count;
  tile.push_constants = bytes_of(constants);
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

}  // namespace

gpu::RasterPass& ShadowMapPasses::pass(const Key& key) {
  const auto found = passes_.find(key);
  if (found != passes_.end()) return found->second;
  const auto [format, spot_light, reversed_z, constant_bias, slope_bias] = key;
  const float away_from_light = reversed_z ? -1.0F : 1.0F;
  gpu::RasterShaders shaders;
  SceneShader shader{"ShadowCaster.hlsl",        "Main",    hlsl::Stage::vertex, reversed_z,
                     mesh_.cut_outs.has_value(), spot_light};
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
  return draw({cascades.atlas_width, cascades.atlas_height, cascades.reversed_z, false}, tiles, settings);
}

ShadowAtlas ShadowMapPasses::draw(const parameters::SpotShadow& spot, const glm::dvec3& origin,
                                  const FrameSettings& settings) {
  return draw({spot.resolution, spot.resolution, spot.reversed_z, true},
              {tile_of(spot, origin, mesh_.vertex_count)}, settings);
}

ShadowAtlas ShadowMapPasses::draw(const Target& target, const std::vector<gpu::RasterTile>& tiles,
                                  const FrameSettings& settings) {
  const DepthFormat format = settings.format;
  const gpu::Image image(device_, gpu_format(format), target.width, target.height);
  gpu::RasterTargets targets;
  targets.depth = &image;
  targets.clear_depth = target.reversed_z ? 0.0F : 1.0F;
  const RasterBias& bias = settings.raster_bias;
  pass({format, target.spot_light, target.reversed_z, bias.constant, bias.slope}).draw(targets, tiles);

  ShadowAtlas atlas;
  atlas.width = target.width;
  atlas.height = target.height;
  atlas.format = format;
  atlas.texels = image.download<std::byte>();
  const std::size_t stride = gpu::texel_bytes(image.format());
  atlas.depth.resize(atlas.texels.size() / stride);
  for (std::size_t texel = 0; texel < atlas.depth.size(); ++texel) {
    atlas.depth[texel] = decode(format, &atlas.texels[texel * stride]);
  }
  return atlas;
}

}  // namespace penumbra::scene
