// Where each step of a pass draws, for a cascade and a mip level, and what its program is told of it.
// Internal to this folder.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "gpu/raster_pass.h"
#include "resolve/graph_resources.h"
#include "resolve/uniform_values.h"
#include "techniques/pass_graph.h"

namespace penumbra::resolve {

class PassGeometry {
 public:
  // All of these have to outlive it.
  PassGeometry(const techniques::PassGraph& graph, const GraphResources& resources,
               const GraphExtents& extents)
      : graph_(graph), resources_(resources), extents_(extents) {}

  // The first of those that it writes, its depth or stencil last; null: none.
  const techniques::GraphTexture* first_written_texture(const techniques::GraphPass& pass) const;

  // What _PenumbraTargetSize and _PenumbraTile are of: of a kernel with a thread for each texel of a texture
  // that texture, otherwise the first that is written.
  const techniques::GraphTexture* target(const techniques::GraphPass& pass) const;

  // Levels of a texture that is made for so many cascades: in the last no tile is smaller than a texel.
  int mips(const techniques::GraphTexture& texture, int cascades) const;

  // `shadow_map`: what casters may be tested against.
  gpu::RasterTargets targets(const techniques::GraphPass& pass, int cascade, int mip,
                             const gpu::Image& shadow_map) const;

  // All of the targets, or one cascade's tile of the map; one triangle over it. Throws InputError, at the
  // texture, where its divisor does not divide the tile.
  gpu::RasterTile tile(const techniques::GraphPass& pass, int cascade, int mip) const;

  // Of a kernel whose number of groups no buffer holds; in a pass for each cascade of its tile or layer
  // alone.
  std::array<std::uint32_t, 3> groups(const techniques::GraphPass& pass,
                                      const std::array<std::uint32_t, 3>& workgroup_size, int mip) const;

  // _PenumbraTargetSize; of every texture that is read _NameSize of _NameTexture, 0 of one that is absent;
  // _PenumbraMip, _PenumbraCascade and _PenumbraTile, where the pass runs for each.
  UniformValues uniforms(const techniques::GraphPass& pass, int cascade, int mip) const;

 private:
  glm::vec4 size_at(const std::string& texture, int mip) const;

  const techniques::PassGraph& graph_;
  const GraphResources& resources_;
  const GraphExtents& extents_;
};

}  // namespace penumbra::resolve
