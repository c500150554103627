#include <stdexcept>

#include "gpu/bindings_state.h"
#include "shaders/reflect.h"

namespace penumbra::gpu {
namespace {

vk::DescriptorType descriptor_of(shaders::ResourceKind kind) {
  switch (kind) {
    case shaders::ResourceKind::uniform_block:
      return vk::DescriptorType::eUniformBuffer;
    case shaders::ResourceKind::storage_buffer:
      return vk::DescriptorType::eStorageBuffer;
    case shaders::ResourceKind::sampled_image:
      return vk::DescriptorType::eSampledImage;
    case shaders::ResourceKind::storage_image:
      return vk::DescriptorType::eStorageImage;
    case shaders::ResourceKind::sampler:
      break;
  }
  return vk::DescriptorType::eSampler;
}

}  // namespace

void require_bound(const BindingsState& bindings, const std::vector<std::uint32_t>& spirv) {
  for (const shaders::Resource& resource : shaders::reflect(spirv).resources) {
    const std::string place = "'" + resource.name + "' at set " + std::to_string(resource.set) + " binding " +
                              std::to_string(resource.binding);
    const auto found = bindings.slots.find({resource.set, resource.binding});
    if (found == bindings.slots.end()) throw std::logic_error("nothing is bound to " + place);
    const BoundResource& bound = found->second;
    if (bound.type != descriptor_of(resource.kind)) {
      throw std::logic_error(vk::to_string(bound.type) + " is bound to " + place + ", which is " +
                             vk::to_string(descriptor_of(resource.kind)));
    }
    if (bound.uniforms.bytes > 0 && bound.uniforms.bytes < resource.size) {
      throw std::logic_error(std::to_string(bound.uniforms.bytes) + " bytes are bound to " + place +
                             ", which has " + std::to_string(resource.size));
    }
  }
}

}  // namespace penumbra::gpu
