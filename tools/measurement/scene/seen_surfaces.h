// Draws the surfaces that the camera sees and turns them into receivers.
#pragma once

#include <optional>

#include "gpu/raster_pass.h"
#include "scene/frame.h"
#include "scene/mesh_on_device.h"

namespace penumbra::scene {

class SeenSurfacesPass {
 public:
  SeenSurfacesPass(const gpu::Device& device, const MeshOnDevice& mesh) : device_(device), mesh_(mesh) {}

  // `scene` must be the one that the mesh was made from.
  Receivers draw(const Scene& scene, const FrameSettings& settings);

 private:
  const gpu::Device& device_;
  const MeshOnDevice& mesh_;
  std::optional<gpu::RasterPass> pass_;
};

}  // namespace penumbra::scene
