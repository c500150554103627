#include "resolve/resolve.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "resolve/provided.h"
#include "shaders/counted_module.h"

namespace penumbra::resolve {
namespace {

const std::vector<std::uint32_t>& words(const CompiledShadowShader& shader, ResolvePass::Module module) {
  return module == ResolvePass::Module::counting ? shader.counting : shader.plain;
}

constexpr const char* kSamplerNames =
    "a name with 'point' or 'linear' and with 'clamp' or 'repeat' (sampler_LinearClamp) is a sampler of that "
    "kind, and 'sampler' followed by the name of a texture of yours is linear and repeating";

std::string texture_way_out(const std::string& name) {
  return "give it one behind the adapter's file: ';" + name + "=picture.png' or ';" + name + "=white'";
}

}  // namespace

ResolvePass::ResolvePass(const gpu::Device& device, const CompiledShadowShader& shader, Module module)
    : name_(shader.source.name),
      named_at_(shader.named_at),
      parameters_(shader.source.parameters),
      numbers_(shader.source.numbers),
      resources_(shaders::reflect(words(shader, module)).resources),
      own_(device, shader.source.textures),
      pass_(device, shader.vertex, words(shader, module)) {
  const auto function = named_at_.find("ShadowVisibility");
  check_numbers(numbers_, resources_, function == named_at_.end() ? name_ : function->second, named_at_);
}

const std::string& ResolvePass::place_of(const shaders::Resource& resource) const {
  const auto found = named_at_.find(resource.name);
  return found == named_at_.end() ? name_ : found->second;
}

void ResolvePass::bind_sampler(const shaders::Resource& resource, const FrameOnDevice& frame) {
  const auto samplers = frame.samplers();
  const gpu::Sampler* own = samplers.count(resource.name) == 0 ? own_.sampler(resource.name) : nullptr;
  pass_.bindings().sampler(
      resource.name,
      own != nullptr ? *own : provided(samplers, resource, place_of(resource), "sampler", kSamplerNames));
}

void ResolvePass::bind(const FrameOnDevice& frame, const TexelCounter* counter) {
  frame_ = &frame;
  auto buffers = frame.buffers();
  if (counter != nullptr) buffers[shaders::texel_counts_name] = &counter->buffer();
  auto images = frame.images();
  for (const auto& [name, image] : own_.images()) images[name] = image;
  for (const shaders::Resource& resource : resources_) {
    switch (resource.kind) {
      case shaders::ResourceKind::uniform_block:
        break;  // packed by run()
      case shaders::ResourceKind::storage_buffer:
        pass_.bindings().buffer(resource.name, provided(buffers, resource, place_of(resource), "buffer"));
        break;
      case shaders::ResourceKind::sampled_image:
        pass_.bindings().image(resource.name, provided(images, resource, place_of(resource), "texture",
                                                       texture_way_out(resource.name)));
        break;
      case shaders::ResourceKind::sampler:
        bind_sampler(resource, frame);
        break;
      case shaders::ResourceKind::storage_image:
        provided(std::map<std::string, const gpu::Image*>(), resource, place_of(resource),
                 "writable texture");
        break;
    }
  }
}

std::vector<double> ResolvePass::run(int noise_seed, int repeats) {
  if (frame_ == nullptr) throw std::logic_error("no frame is bound");
  UniformValues values = frame_->uniforms(noise_seed);
  values.merge(own_.uniforms());
  values.merge(parameters_);
  unset_.clear();
  for (const shaders::Resource& resource : resources_) {
    if (resource.kind != shaders::ResourceKind::uniform_block) continue;
    std::vector<std::byte> bytes = values.pack(resource, unset_);
    write_numbers(numbers_, resource, bytes);
    pass_.bindings().uniform_bytes(resource.name, bytes);
  }
  std::erase_if(unset_, [this](const std::string& name) { return has_numbers(numbers_, name); });
  return pass_.run(frame_->width(), frame_->height(), repeats);
}

std::vector<std::string> ResolvePass::unset_uniforms() const {
  const std::set<std::string> names(unset_.begin(), unset_.end());
  return {names.begin(), names.end()};
}

Resolver::Resolver(const gpu::Device& device, const CompiledShadowShader& shader)
    : device_(device),
      uses_noise_(shader.source.uses_noise),
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
    const TexelCounter counter(device_, frame.width(), frame.height());
    counting_.bind(frame, &counter);
    counting_.run(0);
    result.fetches = counter.counts().fetches;
  }
  result.unset_uniforms = plain_.unset_uniforms();
  return result;
}

}  // namespace penumbra::resolve
