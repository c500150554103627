#include "scene/mesh_on_device.h"

#include <vector>

namespace penumbra::scene {
namespace {

// A buffer cannot be empty, even where no cut-out reads it.
template <typename Element>
gpu::Buffer filled(const gpu::Device& device, const std::vector<Element>& content) {
  static const std::vector<Element> one(1);
  return {device, std::span<const Element>(content.empty() ? one : content)};
}

}  // namespace

MeshOnDevice::CutOutTables::CutOutTables(const gpu::Device& device, const Mesh& mesh, const CutOuts& cut_outs)
    : coordinates(
          filled(device, mesh.uvs.empty() ? std::vector<glm::vec2>(mesh.positions.size()) : mesh.uvs)),
      of_triangle(filled(device, cut_outs.of_triangle())),
      entries(filled(device, cut_outs.entries())),
      texels(filled(device, cut_outs.texels())) {}

MeshOnDevice::MeshOnDevice(const gpu::Device& device, const Mesh& mesh, const CutOuts& given)
    : positions(device, std::span<const glm::vec3>(mesh.positions)),
      normals(device, std::span<const glm::vec3>(mesh.normals)),
      indices(device, std::span<const std::uint32_t>(mesh.indices)),
      vertex_count(static_cast<std::uint32_t>(mesh.indices.size())) {
  if (given.any()) cut_outs.emplace(device, mesh, given);
}

void MeshOnDevice::bind_to(gpu::Bindings& bindings) const {
  const auto bind = [&](const char* name, const gpu::Buffer& buffer) {
    if (bindings.has(name)) bindings.buffer(name, buffer);
  };
  bind("_Positions", positions);
  bind("_Normals", normals);
  bind("_Indices", indices);
  if (!cut_outs) return;
  bind("_TexCoords", cut_outs->coordinates);
  bind("_CutOutOfTriangle", cut_outs->of_triangle);
  bind("_CutOuts", cut_outs->entries);
  bind("_CutOutTexels", cut_outs->texels);
}

}  // namespace penumbra::scene
