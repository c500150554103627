// A mesh's triangles in the buffers SceneMesh.hlsl reads.
#pragma once

#include "gpu/bindings.h"
#include "scene/scene.h"

namespace penumbra::scene {

struct MeshOnDevice {
  MeshOnDevice(const gpu::Device& device, const Mesh& mesh)
      : positions(device, std::span<const glm::vec3>(mesh.positions)),
        normals(device, std::span<const glm::vec3>(mesh.normals)),
        indices(device, std::span<const std::uint32_t>(mesh.indices)),
        vertex_count(static_cast<std::uint32_t>(mesh.indices.size())) {}

  void bind_to(gpu::Bindings& bindings) const {
    bindings.storage_buffer({0, 0}, positions);
    bindings.storage_buffer({0, 1}, normals);
    bindings.storage_buffer({0, 2}, indices);
  }

  gpu::Buffer positions;
  gpu::Buffer normals;
  gpu::Buffer indices;
  std::uint32_t vertex_count;
};

}  // namespace penumbra::scene
