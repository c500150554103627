// One program of a graph on a device, as it ships or with its texels counted. Its bindings and uniforms go by
// the names that its shader gives them. Internal to this folder.
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

// The resources that a program may bind.
struct NamedResources {
  std::map<std::string, BoundImage> images;
  std::map<std::string, const gpu::Sampler*> samplers;
  std::map<std::string, const gpu::Buffer*> buffers;
};

// The targets that a raster program draws into.
struct TargetFormats {
  std::vector<gpu::Format> colours;
  std::optional<gpu::Format> depth{};
  int samples = 1;
  bool stencil = false;  // the depth has a stencil; both are kept
  bool keep = false;     // contents outside of the drawn tiles are kept
  bool casters = false;  // triangles of the scene instead of one over the tile
  bool depth_is_shadow_map = false;
  bool reversed_z = true;
};

// The tile is all of an image, covered by one triangle.
gpu::RasterTile whole_of(const gpu::Image& target);

class ProgramOnDevice {
 public:
  enum class Module { as_shipped, counting };

  // `targets` are those of a raster program. Throws InputError for render states that are not drawn here, for
  // vertex inputs that the scene's triangles lack, and when the vertex stage of a pass over its whole target
  // reads anything.
  ProgramOnDevice(const gpu::Device& device, const CompiledProgram& program, Module module,
                  const TargetFormats& targets = {});

  std::array<std::uint32_t, 3> workgroup_size() const { return workgroup_size_; }

  // Returns the bindings for one more step of a sequence. Throws InputError, naming the line or else the
  // program, for a texture, sampler or buffer that `resources` lacks. For a missing texture the message says
  // how to provide it.
  gpu::Bindings bind(const NamedResources& resources) const;

  // Uniforms without a value are zero; this returns those of them that the program reads. `numbers` win over
  // `values`.
  std::vector<std::string> set_uniforms(gpu::Bindings& bindings, const UniformValues& values,
                                        const UniformNumbers& numbers = {}) const;

  bool is_raster() const { return raster_.has_value(); }
  void dispatch(gpu::Sequence& sequence, const gpu::Bindings& bindings,
                std::array<std::uint32_t, 3> groups) const;
  void draw(gpu::Sequence& sequence, const gpu::Bindings& bindings, const gpu::RasterTargets& targets,
            const gpu::RasterTile& tile, const gpu::VertexStreams& streams = {}) const;

  // Returns the semantics of the vertex shader's inputs, in the order in which draw() takes their streams.
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
  std::optional<gpu::ComputePass> compute_;  // set for a compute shader
  std::optional<gpu::RasterPass> raster_;    // set for a raster program
};

}  // namespace penumbra::resolve
