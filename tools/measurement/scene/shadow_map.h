// Draws the cascade atlas, or the map of a spot light, and reads it back.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "gpu/raster_pass.h"
#include "scene/frame.h"
#include "scene/mesh_on_device.h"

namespace penumbra::scene {

// The passes by format, kind of light, reversed Z, and the rasteriser's constant and slope bias. Each is made
// when first needed.
class ShadowMapPasses {
 public:
  ShadowMapPasses(const gpu::Device& device, const MeshOnDevice& mesh) : device_(device), mesh_(mesh) {}

  // `origin` is the world position of the mesh's own origin.
  ShadowAtlas draw(const parameters::CascadeSet& cascades, const glm::dvec3& origin,
                   const FrameSettings& settings);
  ShadowAtlas draw(const parameters::SpotShadow& spot, const glm::dvec3& origin,
                   const FrameSettings& settings);

 private:
  struct Target {
    int width;
    int height;
    bool reversed_z;
    bool spot_light;
  };
  using Key = std::tuple<DepthFormat, bool, bool, double, double>;

  gpu::RasterPass& pass(const Key& key);
  ShadowAtlas draw(const Target& target, const std::vector<gpu::RasterTile>& tiles,
                   const FrameSettings& settings);

  const gpu::Device& device_;
  const MeshOnDevice& mesh_;
  std::map<Key, gpu::RasterPass> passes_;
};

}  // namespace penumbra::scene
