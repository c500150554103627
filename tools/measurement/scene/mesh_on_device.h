// A mesh's triangles in the buffers SceneMesh.hlsl reads, and its cut-outs in those of CutOut.hlsl.
#pragma once

#include <optional>

#include "gpu/bindings.h"
#include "scene/cut_out.h"
#include "scene/scene.h"

namespace penumbra::scene {

struct MeshOnDevice {
  MeshOnDevice(const gpu::Device& device, const Mesh& mesh, const CutOuts& cut_outs);

  // Binds those of the buffers that the pass's shaders read.
  void bind_to(gpu::Bindings& bindings) const;

  struct CutOutTables {
    CutOutTables(const gpu::Device& device, const Mesh& mesh, const CutOuts& cut_outs);

    gpu::Buffer coordinates;
    gpu::Buffer of_triangle;
    gpu::Buffer entries;
    gpu::Buffer texels;
  };

  gpu::Buffer positions;
  gpu::Buffer normals;
  gpu::Buffer indices;
  std::optional<CutOutTables> cut_outs;  // set for a scene that has cut-outs
  std::uint32_t vertex_count;
};

}  // namespace penumbra::scene
