#include "resolve/graph_resources.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "input/input_error.h"

namespace penumbra::resolve {
namespace {

int rounded_up(int size, int divisor) {
  return std::max(1, (size + divisor - 1) / divisor);
}

void fill_with_zeros(gpu::Image& image) {
  for (int mip = 0; mip < image.shape().mips; ++mip) {
    const std::vector<std::byte> zeros(image.size_bytes(mip));
    for (int layer = 0; layer < image.shape().layers; ++layer)
      image.upload_bytes(zeros, {.mip = mip, .layer = layer});
  }
}

constexpr double kMostBytes = 4.0 * 1024.0 * 1024.0 * 1024.0;

gpu::Image made(const gpu::Device& device, const techniques::GraphTexture& texture,
                const GraphExtents& extents) {
  const auto [width, height, depth] = texture_size_of(texture, extents);
  gpu::ImageShape shape;
  shape.format = measured_format(texture);
  shape.width = width;
  shape.height = height;
  shape.depth = depth;
  shape.layers = texture.extent == techniques::ExtentOf::tile ? static_cast<int>(extents.map.origins.size())
                                                              : texture.layers;
  const int most = gpu::mip_count(width, height, depth);
  shape.mips = texture.mips == 0 ? most : std::min(texture.mips, most);
  shape.samples = texture.samples;
  const double bytes = 4.0 / 3.0 * static_cast<double>(gpu::texel_bytes(shape.format)) * width * height *
                       depth * shape.layers * shape.samples;
  if (bytes > kMostBytes)
    throw InputError(texture.where, "'" + texture.name + "' takes " +
                                        std::to_string(std::llround(bytes / 1048576.0)) +
                                        " MiB, more than 4096");
  try {
    gpu::Image image(device, shape);
    if (shape.samples == 1) fill_with_zeros(image);
    return image;
  } catch (const EnvironmentError& error) {
    throw InputError(texture.where, "texture '" + texture.name + "': " + error.what());
  }
}

}  // namespace

std::array<int, 3> texture_size_of(const techniques::GraphTexture& texture, const GraphExtents& extents) {
  const auto share = [&](int width, int height) {
    return std::array{rounded_up(width, texture.divisor), rounded_up(height, texture.divisor), 1};
  };
  switch (texture.extent) {
    case techniques::ExtentOf::screen:
      return share(extents.screen_width, extents.screen_height);
    case techniques::ExtentOf::map:
      return share(extents.map.width, extents.map.height);
    case techniques::ExtentOf::tile:
      return share(extents.map.tile, extents.map.tile);
    case techniques::ExtentOf::fixed:
      break;
  }
  return texture.size;
}

gpu::Format measured_format(const techniques::GraphTexture& texture) {
  if (texture.format == "r8") return gpu::Format::r32f;
  if (texture.format == "rg8") return gpu::Format::rg32f;
  if (texture.format == "rgba8") return gpu::Format::rgba32f;
  return gpu::find_format(texture.format).value();
}

GraphResources::GraphResources(const gpu::Device& device, const techniques::PassGraph& graph,
                               const GraphExtents& extents) {
  for (const techniques::GraphTexture& texture : graph.textures)
    textures_.emplace(texture.name, made(device, texture, extents));
}

void require_whole_tiles(const techniques::PassGraph& graph, const std::string& subject, int tile_texels,
                         int tiles_across) {
  for (const techniques::GraphPass& pass : graph.passes) {
    if (pass.frequency != techniques::Frequency::cascade) continue;
    for (const auto& [shader_name, name] : pass.writes) {
      const techniques::GraphTexture& texture = *graph.texture(name);
      if (texture.extent != techniques::ExtentOf::map || tile_texels % texture.divisor == 0) continue;
      const std::string divisor = std::to_string(texture.divisor);
      throw InputError(
          "",
          "'" + subject + "' makes a texel of '" + name + "' of " + divisor + " x " + divisor +
              " texels of the shadow map, and a cascade's tile of " + std::to_string(tile_texels) +
              " texels is no multiple of " + divisor,
          "choose a map size that is a multiple of " + std::to_string(texture.divisor * tiles_across));
    }
  }
}

}  // namespace penumbra::resolve
