#include "resolve/resolve.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "resolve/provided.h"

namespace penumbra::resolve {
namespace {

constexpr std::uint32_t kTile = 8;  // numthreads of Resolve.hlsl

std::uint32_t groups(int pixels) {
  return (static_cast<std::uint32_t>(pixels) + kTile - 1) / kTile;
}

const std::vector<std::uint32_t>& words(const CompiledShadowShader& shader, ResolvePass::Module module) {
  return module == ResolvePass::Module::counting ? shader.counting : shader.plain;
}

}  // namespace

ResolvePass::ResolvePass(const gpu::Device& device, const CompiledShadowShader& shader, Module module)
    : name_(shader.source.name),
      parameters_(shader.source.parameters),
      resources_(shaders::reflect(words(shader, module)).resources),
      pass_(device, {.spirv = words(shader, module), .entry = "Main"}) {}

void ResolvePass::bind(const FrameOnDevice& frame) {
  frame_ = &frame;
  const auto buffers = frame.buffers();
  const auto images = frame.images();
  const auto samplers = frame.samplers();
  for (const shaders::Resource& resource : resources_) {
    const gpu::Slot slot{resource.set, resource.binding};
    switch (resource.kind) {
      case shaders::ResourceKind::uniform_block:
        break;  // packed by run()
      case shaders::ResourceKind::storage_buffer:
        pass_.bindings().storage_buffer(slot, provided(buffers, resource, name_, "buffer"));
        break;
      case shaders::ResourceKind::sampled_image:
        pass_.bindings().sampled_image(slot, provided(images, resource, name_, "texture"));
        break;
      case shaders::ResourceKind::sampler:
        pass_.bindings().sampler(slot, provided(samplers, resource, name_, "sampler"));
        break;
      case shaders::ResourceKind::storage_image:
        provided(std::map<std::string, const gpu::Image*>(), resource, name_, "writable texture");
        break;
    }
  }
}

std::vector<double> ResolvePass::run(int noise_seed, int repeats) {
  if (frame_ == nullptr) throw std::logic_error("no frame is bound");
  UniformValues values = frame_->uniforms(noise_seed);
  values.merge(parameters_);
  unset_.clear();
  for (const shaders::Resource& resource : resources_) {
    if (resource.kind != shaders::ResourceKind::uniform_block) continue;
    pass_.bindings().uniform_bytes({resource.set, resource.binding}, values.pack(resource, unset_));
  }
  return pass_.dispatch({groups(frame_->width()), groups(frame_->height()), 1}, repeats);
}

std::vector<std::string> ResolvePass::unset_uniforms() const {
  const std::set<std::string> names(unset_.begin(), unset_.end());
  return {names.begin(), names.end()};
}

Resolver::Resolver(const gpu::Device& device, const CompiledShadowShader& shader)
    : uses_noise_(shader.source.uses_noise),
      plain_(device, shader),
      counting_(device, shader, ResolvePass::Module::counting) {}

ResolveResult Resolver::resolve(const FrameOnDevice& frame, const ResolveOptions& options) {
  ResolveResult result;
  plain_.bind(frame);
  const int seeds = uses_noise_ ? std::max(1, options.noise_seeds) : 1;
  for (int seed = 0; seed < seeds; ++seed) {
    plain_.run(options.first_seed + seed);
    result.visibility.push_back(frame.visibility().download<float>());
  }
  if (options.timing_repeats > 0) result.time_ns = plain_.run(0, options.timing_repeats);
  if (options.count_fetches) {
    counting_.bind(frame);
    counting_.run(0);
    result.fetches = frame.fetches().download<std::uint32_t>();
  }
  result.unset_uniforms = plain_.unset_uniforms();
  return result;
}

}  // namespace penumbra::resolve
