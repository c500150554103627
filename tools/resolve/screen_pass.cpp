#include "resolve/screen_pass.h"

#include <set>

#include "resolve/provided.h"

namespace penumbra::resolve {
namespace {

gpu::RasterShaders shaders_of(const CompiledScreenPass& compiled, ScreenPass::Module module) {
  gpu::RasterShaders shaders;
  shaders.vertex = compiled.vertex;
  shaders.fragment = module == ScreenPass::Module::counting ? compiled.counting : compiled.fragment;
  shaders.vertex_entry = compiled.vertex_entry;
  shaders.fragment_entry = compiled.fragment_entry;
  shaders.colours = {ScreenPass::target_format(module)};
  return shaders;
}

}  // namespace

gpu::Format ScreenPass::target_format(Module module) {
  return module == Module::in_colour ? gpu::Format::rgba32f : gpu::Format::r32f;
}

ScreenPass::ScreenPass(const gpu::Device& device, const CompiledScreenPass& compiled, Module module)
    : name_(compiled.name), pass_(device, shaders_of(compiled, module)) {
  const std::vector<shaders::Resource> of_vertex = shaders::reflect(compiled.vertex).resources;
  if (!of_vertex.empty()) {
    throw InputError(name_, "the vertex stage reads '" + of_vertex.front().name + "'",
                     "the vertex stage of a screen pass needs only SV_VertexID");
  }
  bound_ = shaders::reflect(module == Module::counting ? compiled.counting : compiled.fragment).resources;
}

double ScreenPass::draw(const gpu::Image& target, const ScreenResources& resources,
                        const UniformValues& values) {
  unset_.clear();
  for (const shaders::Resource& resource : bound_) {
    switch (resource.kind) {
      case shaders::ResourceKind::uniform_block:
        pass_.bindings().uniform_bytes(resource.name, values.pack(resource, unset_));
        break;
      case shaders::ResourceKind::sampled_image:
        pass_.bindings().image(resource.name, provided(resources.images, resource, name_, "texture"));
        break;
      case shaders::ResourceKind::sampler:
        pass_.bindings().sampler(resource.name, provided(resources.samplers, resource, name_, "sampler"));
        break;
      case shaders::ResourceKind::storage_buffer:
        pass_.bindings().buffer(resource.name, provided(resources.buffers, resource, name_, "buffer"));
        break;
      case shaders::ResourceKind::storage_image:
        provided(std::map<std::string, const gpu::Image*>(), resource, name_, "writable texture");
        break;
    }
  }
  gpu::RasterTile whole;
  whole.width = target.width();
  whole.height = target.height();
  whole.vertex_count = 3;  // one triangle over all of it
  return pass_.draw({{&target}, nullptr, 0.0F}, {whole});
}

std::vector<std::string> ScreenPass::unset_uniforms() const {
  const std::set<std::string> names(unset_.begin(), unset_.end());
  return {names.begin(), names.end()};
}

}  // namespace penumbra::resolve
