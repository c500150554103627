#include "gpu/pass_interface.h"

#include <algorithm>
#include <map>

#include "shaders/spirv_module.h"

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

void make_layouts(PassInterface& interface, std::uint32_t push_constant_bytes) {
  std::map<std::uint32_t, std::vector<vk::DescriptorSetLayoutBinding>> by_set;
  for (const InterfaceSlot& slot : interface.slots)
    by_set[slot.set].emplace_back(slot.resource.binding, slot.type, 1, slot.stage);
  const std::uint32_t sets = by_set.empty() ? 0 : by_set.rbegin()->first + 1;
  std::vector<vk::DescriptorSetLayout> handles;
  for (std::uint32_t set = 0; set < sets; ++set) {
    interface.layouts.emplace_back(interface.device->device,
                                   vk::DescriptorSetLayoutCreateInfo({}, by_set[set]));
    handles.push_back(*interface.layouts.back());
  }
  const vk::PushConstantRange range(interface.stages, 0, push_constant_bytes);
  vk::PipelineLayoutCreateInfo create({}, handles);
  if (push_constant_bytes > 0) create.setPushConstantRanges(range);
  interface.pipeline_layout = vk::raii::PipelineLayout(interface.device->device, create);
}

}  // namespace

std::shared_ptr<PassInterface> make_interface(const std::shared_ptr<DeviceState>& device,
                                              std::vector<StageModule>& modules,
                                              std::uint32_t push_constant_bytes) {
  auto interface = std::make_shared<PassInterface>();
  interface->device = device;
  std::uint32_t next_set = 0;
  for (StageModule& module : modules) {
    interface->stages |= module.stage;
    shaders::move_sets(module.spirv, next_set);
    shaders::initialise_tables(module.spirv);
    std::uint32_t behind = next_set;
    for (shaders::Resource& resource : shaders::reflect(module.spirv).resources) {
      behind = std::max(behind, resource.set + 1);
      InterfaceSlot slot;
      slot.set = resource.set;
      slot.type = descriptor_of(resource.kind);
      slot.stage = module.stage;
      slot.resource = std::move(resource);
      interface->slots.push_back(std::move(slot));
    }
    next_set = behind;
  }
  guarded(*device, "make a pass", [&] { make_layouts(*interface, push_constant_bytes); });
  return interface;
}

}  // namespace penumbra::gpu
