#include "scene/mesh_on_device.h"

#include "shaders/reflect.h"

namespace penumbra::scene {

MeshOnDevice::MeshOnDevice(const gpu::Device& device, const Mesh& mesh)
    : positions(device, std::span<const glm::vec3>(mesh.positions)),
      normals(device, std::span<const glm::vec3>(mesh.normals)),
      indices(device, std::span<const std::uint32_t>(mesh.indices)),
      vertex_count(static_cast<std::uint32_t>(mesh.indices.size())) {}

void MeshOnDevice::bind_to(gpu::Bindings& bindings, const std::vector<std::uint32_t>& vertex_spirv) const {
  for (const shaders::Resource& resource : shaders::reflect(vertex_spirv).resources) {
    const gpu::Slot slot{resource.set, resource.binding};
    if (resource.name == "_Positions") bindings.storage_buffer(slot, positions);
    if (resource.name == "_Normals") bindings.storage_buffer(slot, normals);
    if (resource.name == "_Indices") bindings.storage_buffer(slot, indices);
  }
}

}  // namespace penumbra::scene
