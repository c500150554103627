// Runs one shadow shader over the receivers of a frame: visibility per noise seed, fetches, time.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "resolve/adapter_resources.h"
#include "resolve/frame_on_device.h"
#include "resolve/receiver_pass.h"
#include "resolve/shadow_shader.h"
#include "resolve/texel_counter.h"
#include "shaders/reflect.h"

namespace penumbra::resolve {

struct ResolveOptions {
  int noise_seeds = 16;  // visibility images; shaders without noise are run once
  int first_seed = 0;
  int timing_repeats = 5;  // further dispatches whose times are kept; 0: none
  bool count_fetches = true;
};

struct ResolveResult {
  std::vector<std::vector<float>> visibility;  // per seed, one per receiver, row 0 at the top; 1 = lit
  std::vector<std::uint32_t> fetches;          // per receiver, of seed 0; empty unless counted
  std::vector<double> time_ns;                 // of the shader as it ships, without counting
  std::vector<std::string> unset_uniforms;     // read as zero because nobody provides them
};

// One compiled module on a device. Frames are swapped without building the pipeline again, which on a
// software device costs more than running it.
class ResolvePass {
 public:
  enum class Module { as_shipped, counting };

  ResolvePass(const gpu::Device& device, const CompiledShadowShader& shader,
              Module module = Module::as_shipped);

  // The frame must outlive its use here. A counting module adds to `counter`. Throws InputError when the
  // shader binds a texture, sampler or buffer the harness does not provide. The shader's own parameters win
  // over the frame's uniforms.
  void bind(const FrameOnDevice& frame, const TexelCounter* counter = nullptr);
  void set_parameters(const UniformValues& parameters) { parameters_.merge(parameters); }

  // Times in nanoseconds, one per repeat; the answer lies in the frame's buffers.
  std::vector<double> run(int noise_seed, int repeats = 1);

  std::vector<std::string> unset_uniforms() const;

 private:
  // Where messages say that a resource is named: its line, or else the shader.
  const std::string& place_of(const shaders::Resource& resource) const;
  void bind_sampler(const shaders::Resource& resource, const FrameOnDevice& frame);

  std::string name_;
  std::map<std::string, std::string> named_at_;
  UniformValues parameters_;
  UniformNumbers numbers_;
  std::vector<shaders::Resource> resources_;
  AdapterResources own_;
  ReceiverPass pass_;
  const FrameOnDevice* frame_ = nullptr;
  std::vector<std::string> unset_;
};

// Both modules of a shader on a device, built once for any number of frames.
class Resolver {
 public:
  Resolver(const gpu::Device& device, const CompiledShadowShader& shader);

  // Throws InputError when the shader binds a texture, sampler or buffer the harness does not provide.
  ResolveResult resolve(const FrameOnDevice& frame, const ResolveOptions& options = {});

 private:
  const gpu::Device& device_;
  bool uses_noise_;
  ResolvePass plain_;
  ResolvePass counting_;
};

}  // namespace penumbra::resolve
