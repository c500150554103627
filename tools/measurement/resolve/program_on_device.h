// One program of a graph on a device, as it ships or with its texels counted: what it binds and its uniforms,
// by the names that its shader gives them. Internal to this folder.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gpu/sequence.h"
#include "resolve/compiled_graph.h"
#include "resolve/raster_state.h"
#include "resolve/uniform_values.h"
#include "shaders/reflect.h"

namespace penumbra::resolve {

struct BoundImage {
  const gpu::Image* image = nullptr;
  gpu::ImageRange range{};
};

// What a program may bind.
struct NamedResources {
  std::map<std::string, BoundImage> images;
  std::map<std::string, const gpu::Sampler*> samplers;
  std::map<std::string, const gpu::Buffer*> buffers;
};

// What a raster program draws into.
struct TargetFormats {
  std::vector<gpu::Format> colours;
  std::optional<gpu::Format> depth{};
  int samples = 1;
  bool stencil = false;  // of the depth, both of which are kept
  bool keep = false;     // what the targets hold outside of the tiles that are drawn
  bool casters = false;  // triangles of the scene instead of one over the tile
  bool depth_is_shadow_map = false;
  bool reversed_z = true;
};

// All of an image, by one triangle.
gpu::RasterTile whole_of(const gpu::Image& target);

class ProgramOnDevice {
 public:
  enum class Module { as_shipped, counting };

  // `targets`: of a raster program. Throws InputError for render states that are not drawn here, for vertex
  // inputs that the scene's triangles lack, and when the vertex stage of a pass over its whole target reads
  // anything.
  ProgramOnDevice(const gpu::Device& device, const CompiledProgram& program, Module module,
                  const TargetFormats& targets = {});

  std::array<std::uint32_t, 3> workgroup_size() const { return workgroup_size_; }

  // For one more step of a sequence. Throws InputError, naming the line or else the program, for a texture,
  // sampler or buffer that `resources` lacks; `way_out` says of a missing texture how to provide it.
  gpu::Bindings bind(const NamedResources& resources) const;

  // Uniforms without a value are zero; those of them that the program reads are returned. `numbers` win over
  // `values`.
  std::vector<std::string> set_uniforms(gpu::Bindings& bindings, const UniformValues& values,
                                        const UniformNumbers& numbers = {}) const;

  bool is_raster() const { return raster_.has_value(); }
  void dispatch(gpu::Sequence& sequence, const gpu::Bindings& bindings,
                std::array<std::uint32_t, 3> groups) const;
  void dispatch_indirect(gpu::Sequence& sequence, const gpu::Bindings& bindings,
                         const gpu::Buffer& groups) const;
  void draw(gpu::Sequence& sequence, const gpu::Bindings& bindings, const gpu::RasterTargets& targets,
            const gpu::RasterTile& tile, const gpu::VertexStreams& streams = {}) const;

  // Semantics of the vertex shader's inputs, in the order in which draw() takes their streams.
  const std::vector<std::string>& vertex_inputs() const { return vertex_inputs_; }

  const std::vector<shaders::Resource>& resources() const { return resources_; }

 private:
  const std::string& place_of(const shaders::Resource& resource) const;

  std::string name_;
  std::string declared_at_;
  std::map<std::string, std::string> named_at_;
  std::vector<shaders::Resource> resources_;
  std::vector<std::string> vertex_inputs_;
  std::array<std::uint32_t, 3> workgroup_size_{};
  std::optional<gpu::ComputePass> compute_;  // this or
  std::optional<gpu::RasterPass> raster_;    // that
};

}  // namespace penumbra::resolve
