// A mesh's triangles in the buffers SceneMesh.hlsl reads.
#pragma once

#include "gpu/bindings.h"
#include "scene/scene.h"

namespace penumbra::scene {

struct MeshOnDevice {
  MeshOnDevice(const gpu::Device& device, const Mesh& mesh);

  // Into the slots the compiler gave the vertex shader's buffers, found by name.
  void bind_to(gpu::Bindings& bindings, const std::vector<std::uint32_t>& vertex_spirv) const;

  gpu::Buffer positions;
  gpu::Buffer normals;
  gpu::Buffer indices;
  std::uint32_t vertex_count;
};

}  // namespace penumbra::scene
