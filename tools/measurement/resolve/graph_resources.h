// The textures of a graph, made for one frame. Internal to this folder.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "gpu/resources.h"
#include "techniques/pass_graph.h"

namespace penumbra::resolve {

// The places of the cascades' tiles in the shadow map.
struct MapLayout {
  int width = 0;  // texels, all cascades
  int height = 0;
  int tile = 0;                             // side of a cascade's square tile
  std::vector<std::array<int, 2>> origins;  // x, y of each cascade's tile
};

// The sizes in texels that a graph's extents are shares of.
struct GraphExtents {
  int screen_width = 0;
  int screen_height = 0;
  MapLayout map;
};

// Returns width, height and depth of a texture at its first mip level.
std::array<int, 3> texture_size_of(const techniques::GraphTexture& texture, const GraphExtents& extents);

// Returns the format in which a texture is measured. Textures of 8 bits for each channel are measured in
// floats: ray tracing is compared with what the passes compute, without the rounding of the texture that
// holds it, at most 1/510. All other formats are as declared.
gpu::Format measured_format(const techniques::GraphTexture& texture);

class GraphResources {
 public:
  // All contents begin as 0. Throws InputError, at the texture's place, for a format that the device lacks.
  GraphResources(const gpu::Device& device, const techniques::PassGraph& graph, const GraphExtents& extents);

  const gpu::Image& texture(const std::string& name) const { return textures_.at(name); }
  gpu::Image& texture(const std::string& name) { return textures_.at(name); }
  bool is_texture(const std::string& name) const { return textures_.count(name) != 0; }

 private:
  std::map<std::string, gpu::Image> textures_;
};

// If a texture is written for one cascade after the other and its texels stand for several of the map's, it
// needs a tile of whole texels: otherwise two cascades share one. Throws InputError with the texture, the
// tile and the way out. `subject` is the owner of the graph; `tiles_across` counts the map's tiles.
void require_whole_tiles(const techniques::PassGraph& graph, const std::string& subject, int tile_texels,
                         int tiles_across);

}  // namespace penumbra::resolve
