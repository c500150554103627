#include "resolve/pass_geometry.h"

#include <algorithm>
#include <string_view>

#include "resolve/camera_image.h"

namespace penumbra::resolve {
namespace {

using techniques::GraphPass;
using techniques::GraphTexture;

// Returns _PenumbraSourceSize for _PenumbraSourceTexture.
std::string size_uniform(const std::string& texture) {
  constexpr std::string_view kEnding = "Texture";
  const bool ends = texture.ends_with(kEnding);
  return (ends ? texture.substr(0, texture.size() - kEnding.size()) : texture) + "Size";
}

bool runs_for_each_tile(const GraphPass& pass, const GraphTexture& target) {
  return pass.frequency == techniques::Frequency::cascade && target.extent == techniques::ExtentOf::map;
}

}  // namespace

const GraphTexture* PassGeometry::first_written_texture(const GraphPass& pass) const {
  if (!pass.writes.empty()) return graph_.texture(pass.writes.front().second);
  return graph_.texture(pass.stencil.empty() ? pass.depth : pass.stencil);
}

const GraphTexture* PassGeometry::target(const GraphPass& pass) const {
  if (!pass.groups.texels_of.empty()) return graph_.texture(pass.groups.texels_of);
  return first_written_texture(pass);
}

int PassGeometry::mips(const GraphTexture& texture, int cascades) const {
  int levels = resources_.texture(texture.name).shape().mips;
  if (cascades == 1 || texture.extent != techniques::ExtentOf::map) return levels;
  while (levels > 1 && extents_.map.tile / (texture.divisor << (levels - 1)) < 1) --levels;
  return levels;
}

gpu::RasterTargets PassGeometry::targets(const GraphPass& pass, int cascade, int mip,
                                         const gpu::Image& shadow_map) const {
  const auto drawn = [&](const std::string& name) {
    const bool layers = graph_.texture(name)->extent == techniques::ExtentOf::tile;
    return gpu::RasterTarget(&resources_.texture(name), mip, layers ? cascade : 0);
  };
  gpu::RasterTargets targets;
  for (const auto& [shader_name, name] : pass.writes) targets.colours.push_back(drawn(name));
  if (pass.depth == techniques::shadow_map_name)
    targets.depth = &shadow_map;
  else if (!pass.depth.empty())
    targets.depth = drawn(pass.depth);
  else if (!pass.stencil.empty())
    targets.depth = drawn(pass.stencil);
  return targets;
}

gpu::RasterTile PassGeometry::tile(const GraphPass& pass, int cascade, int mip) const {
  gpu::RasterTile tile;
  tile.vertex_count = 3;
  const GraphTexture* texture = target(pass);
  if (texture == nullptr) return tile;
  const gpu::Image& image = resources_.texture(texture->name);
  tile.width = gpu::mip_size(image.width(), mip);
  tile.height = gpu::mip_size(image.height(), mip);
  if (!runs_for_each_tile(pass, *texture)) return tile;
  const int scale = texture->divisor << mip;
  const std::array<int, 2>& origin = extents_.map.origins.at(static_cast<std::size_t>(cascade));
  tile.x = origin[0] / scale;
  tile.y = origin[1] / scale;
  tile.width = std::max(1, extents_.map.tile / scale);
  tile.height = tile.width;
  return tile;
}

std::array<std::uint32_t, 3> PassGeometry::groups(const GraphPass& pass,
                                                  const std::array<std::uint32_t, 3>& workgroup_size) const {
  std::array<std::uint32_t, 3> groups{};
  if (pass.groups.texels_of.empty()) {
    for (std::size_t k = 0; k < 3; ++k) groups[k] = static_cast<std::uint32_t>(pass.groups.fixed[k]);
    return groups;
  }
  const gpu::ImageShape& shape = resources_.texture(pass.groups.texels_of).shape();
  const GraphTexture& texture = *graph_.texture(pass.groups.texels_of);
  std::array<int, 3> texels{shape.width, shape.height, std::max(shape.depth, shape.layers)};
  if (pass.frequency == techniques::Frequency::cascade) {
    if (texture.extent == techniques::ExtentOf::tile) texels[2] = 1;
    if (texture.extent == techniques::ExtentOf::map)
      texels[0] = texels[1] = std::max(1, extents_.map.tile / texture.divisor);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t texels_per_group =
        workgroup_size[k] * (k < 2 ? static_cast<std::uint32_t>(pass.groups.divisor) : 1U);
    groups[k] = (static_cast<std::uint32_t>(texels[k]) + texels_per_group - 1) / texels_per_group;
  }
  return groups;
}

UniformValues PassGeometry::uniforms(const GraphPass& pass, int cascade, int mip) const {
  UniformValues values;
  for (const auto& [shader_name, name] : pass.reads) {
    const bool level_before = pass.each_mip && techniques::writes_to(pass, name);
    values.set(size_uniform(shader_name), size_at(name, level_before ? mip - 1 : 0));
  }
  for (const std::string& shader_name : pass.absent) values.set(size_uniform(shader_name), glm::vec4(0.0f));
  if (const GraphTexture* texture = target(pass))
    values.set("_PenumbraTargetSize", size_at(texture->name, mip));
  if (pass.each_mip) values.set("_PenumbraMip", mip);
  if (pass.frequency == techniques::Frequency::cascade) {
    const gpu::RasterTile drawn = tile(pass, cascade, mip);
    values.set("_PenumbraCascade", cascade);
    values.set("_PenumbraTile", glm::vec4(static_cast<float>(drawn.x), static_cast<float>(drawn.y),
                                          static_cast<float>(drawn.width), static_cast<float>(drawn.height)));
  }
  return values;
}

glm::vec4 PassGeometry::size_at(const std::string& texture, int mip) const {
  const gpu::Image& image = resources_.texture(texture);
  return texture_size(gpu::mip_size(image.width(), mip), gpu::mip_size(image.height(), mip));
}

}  // namespace penumbra::resolve
