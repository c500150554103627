// Draws the cascade atlas and reads it back.
#pragma once

#include <map>
#include <utility>

#include "gpu/raster_pass.h"
#include "scene/frame.h"
#include "scene/mesh_on_device.h"

namespace penumbra::scene {

// Passes by (format, reversed Z), made when first asked for.
class ShadowMapPasses {
 public:
  ShadowMapPasses(const gpu::Device& device, const MeshOnDevice& mesh) : device_(device), mesh_(mesh) {}

  // origin: the world position of the mesh's own origin.
  ShadowAtlas draw(const parameters::CascadeSet& cascades, const glm::dvec3& origin, DepthFormat format);

 private:
  gpu::RasterPass& pass(DepthFormat format, bool reversed_z);

  const gpu::Device& device_;
  const MeshOnDevice& mesh_;
  std::map<std::pair<DepthFormat, bool>, gpu::RasterPass> passes_;
};

}  // namespace penumbra::scene
