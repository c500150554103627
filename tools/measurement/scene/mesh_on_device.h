// A mesh's triangles in the buffers SceneMesh.hlsl reads, and its cut-outs in those of CutOut.hlsl.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gpu/bindings.h"
#include "scene/cut_out.h"
#include "scene/scene.h"
#include "shaders/compile.h"

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

// The rasteriser's own shaders, compiled from tools/measurement/scene/shaders below the data directory.
struct SceneShader {
  std::string file;
  std::string entry;
  hlsl::Stage stage;
  bool reversed_z;
  bool cut_outs = false;  // the scene has cut-outs
};

// Throws EnvironmentError with the compiler's messages, because these files are ours and not the user's.
std::vector<std::uint32_t> compile_scene_shader(const SceneShader& shader);

}  // namespace penumbra::scene
