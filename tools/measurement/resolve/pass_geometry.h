// The place where each step of a pass draws, for a cascade and a mip level, and the uniforms that describe it
// to the pass's program. Internal to this folder.
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
  // All arguments have to outlive the object.
  PassGeometry(const techniques::PassGraph& graph, const GraphResources& resources,
               const GraphExtents& extents)
      : graph_(graph), resources_(resources), extents_(extents) {}

  // Returns the first of the textures that the pass writes, its depth or stencil last; null for a filter.
  const techniques::GraphTexture* first_written_texture(const techniques::GraphPass& pass) const;

  // Returns the texture that _PenumbraTargetSize and _PenumbraTile describe. A kernel with a thread for each
  // texel of a texture has that texture; other passes have the first that they write.
  const techniques::GraphTexture* target(const techniques::GraphPass& pass) const;

  // Returns the number of levels of a texture that is made for so many cascades: in the last level no tile is
  // smaller than a texel.
  int mips(const techniques::GraphTexture& texture, int cascades) const;

  // Casters may be tested against `shadow_map`.
  gpu::RasterTargets targets(const techniques::GraphPass& pass, int cascade, int mip,
                             const gpu::Image& shadow_map) const;

  // Returns the whole of the targets, or one cascade's tile of the map; one triangle covers it. Throws
  // InputError, at the texture, where its divisor does not divide the tile.
  gpu::RasterTile tile(const techniques::GraphPass& pass, int cascade, int mip) const;

  // Returns the groups of a kernel. In a pass for each cascade they cover its tile or layer alone.
  std::array<std::uint32_t, 3> groups(const techniques::GraphPass& pass,
                                      const std::array<std::uint32_t, 3>& workgroup_size) const;

  // Returns _PenumbraTargetSize; _NameSize for every _NameTexture that is read, 0 for one that is absent; and
  // _PenumbraMip, _PenumbraCascade and _PenumbraTile, where the pass runs for each.
  UniformValues uniforms(const techniques::GraphPass& pass, int cascade, int mip) const;

 private:
  glm::vec4 size_at(const std::string& texture, int mip) const;

  const techniques::PassGraph& graph_;
  const GraphResources& resources_;
  const GraphExtents& extents_;
};

}  // namespace penumbra::resolve
