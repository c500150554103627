// A mesh's triangles in the buffers SceneMesh.hlsl reads.
#pragma once

#include "gpu/bindings.h"
#include "scene/scene.h"

namespace penumbra::scene {

struct MeshOnDevice {
  MeshOnDevice(const gpu::Device& device, const Mesh& mesh);

  // Those of the buffers that the vertex shader reads.
  void bind_to(gpu::Bindings& bindings) const;

  gpu::Buffer positions;
  gpu::Buffer normals;
  gpu::Buffer indices;
  std::uint32_t vertex_count;
};

}  // namespace penumbra::scene
