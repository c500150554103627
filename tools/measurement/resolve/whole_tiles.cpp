#include "resolve/whole_tiles.h"

#include "input/input_error.h"

namespace penumbra::resolve {

void require_whole_tiles(const techniques::PassGraph& graph, const std::string& subject, int tile_texels,
                         int tiles_across) {
  for (const techniques::GraphPass& pass : graph.passes) {
    if (pass.frequency != techniques::Frequency::cascade) continue;
    for (const auto& [shader_name, name] : pass.writes) {
      const techniques::GraphTexture* texture = graph.texture(name);
      if (texture == nullptr || texture->extent != techniques::ExtentOf::map) continue;
      if (tile_texels % texture->divisor == 0) continue;
      const std::string divisor = std::to_string(texture->divisor);
      throw InputError(
          "",
          "'" + subject + "' makes a texel of '" + name + "' of " + divisor + " x " + divisor +
              " texels of the shadow map, and a cascade's tile of " + std::to_string(tile_texels) +
              " texels is no multiple of " + divisor,
          "choose a map size that is a multiple of " + std::to_string(texture->divisor * tiles_across));
    }
  }
}

}  // namespace penumbra::resolve
