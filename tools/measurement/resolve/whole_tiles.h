// Whether the textures of a graph fit the tiles of a shadow map.
#pragma once

#include <string>

#include "techniques/pass_graph.h"

namespace penumbra::resolve {

// Textures that are written for one cascade after the other and whose texels stand for several of the map's
// need a tile of whole texels: else two cascades share one. Throws InputError with the texture, the tile and
// the way out. `subject`: what the graph belongs to; tiles_across: of the map.
void require_whole_tiles(const techniques::PassGraph& graph, const std::string& subject, int tile_texels,
                         int tiles_across);

}  // namespace penumbra::resolve
