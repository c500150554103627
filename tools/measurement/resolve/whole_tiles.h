// A check that the textures of a graph fit the tiles of a shadow map.
#pragma once

#include <string>

#include "techniques/pass_graph.h"

namespace penumbra::resolve {

// If a texture is written for one cascade after the other and its texels stand for several of the map's, it
// needs a tile of whole texels: otherwise two cascades share one. Throws InputError with the texture, the
// tile and the way out. `subject` is the owner of the graph; `tiles_across` counts the map's tiles.
void require_whole_tiles(const techniques::PassGraph& graph, const std::string& subject, int tile_texels,
                         int tiles_across);

}  // namespace penumbra::resolve
