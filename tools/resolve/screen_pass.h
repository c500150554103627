// One pass of a .shader on a device: draws its full-screen triangle into a target.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "gpu/raster_pass.h"
#include "resolve/screen_shader.h"
#include "resolve/uniform_values.h"
#include "shaders/reflect.h"

namespace penumbra::resolve {

// What a pass may bind, by the names shaders use. Passes of the package read no buffers; a counting one adds
// to that of a TexelCounter.
struct ScreenResources {
  std::map<std::string, const gpu::Image*> images;
  std::map<std::string, const gpu::Sampler*> samplers;
  std::map<std::string, const gpu::Buffer*> buffers{};
};

class ScreenPass {
 public:
  enum class Module { as_shipped, in_colour, counting };

  // Targets are r32f, or rgba32f in colour. Throws InputError when the vertex stage binds anything: it has
  // nothing to read.
  ScreenPass(const gpu::Device& device, const CompiledScreenPass& compiled, Module module);

  static gpu::Format target_format(Module module);

  // The time in nanoseconds. Throws InputError for a texture, sampler or buffer that `resources` lacks.
  // Uniforms without a value are zero, and named by unset_uniforms().
  double draw(const gpu::Image& target, const ScreenResources& resources, const UniformValues& values);

  std::vector<std::string> unset_uniforms() const;

 private:
  std::string name_;
  std::vector<shaders::Resource> bound_;
  gpu::RasterPass pass_;
  std::vector<std::string> unset_;
};

}  // namespace penumbra::resolve
