#include "scene/mesh_on_device.h"

namespace penumbra::scene {

MeshOnDevice::MeshOnDevice(const gpu::Device& device, const Mesh& mesh)
    : positions(device, std::span<const glm::vec3>(mesh.positions)),
      normals(device, std::span<const glm::vec3>(mesh.normals)),
      indices(device, std::span<const std::uint32_t>(mesh.indices)),
      vertex_count(static_cast<std::uint32_t>(mesh.indices.size())) {}

void MeshOnDevice::bind_to(gpu::Bindings& bindings) const {
  if (bindings.has("_Positions")) bindings.buffer("_Positions", positions);
  if (bindings.has("_Normals")) bindings.buffer("_Normals", normals);
  if (bindings.has("_Indices")) bindings.buffer("_Indices", indices);
}

}  // namespace penumbra::scene
