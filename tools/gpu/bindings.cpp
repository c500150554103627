#include "gpu/bindings.h"

#include <cstring>
#include <stdexcept>

#include "gpu/bindings_state.h"

namespace penumbra::gpu {
namespace {

std::string place(std::uint32_t set, std::uint32_t binding) {
  return "set " + std::to_string(set) + " binding " + std::to_string(binding);
}

void require_same_device(const std::shared_ptr<DeviceState>& ours,
                         const std::shared_ptr<DeviceState>& theirs) {
  if (ours != theirs) throw std::logic_error("a resource of another device is bound");
}

vk::ImageLayout layout_for(vk::DescriptorType type) {
  return type == vk::DescriptorType::eStorageImage ? vk::ImageLayout::eGeneral
                                                   : vk::ImageLayout::eShaderReadOnlyOptimal;
}

}  // namespace

Bindings::Bindings(const Device& device) : state_(std::make_shared<BindingsState>()) {
  state_->device = device.state();
}

void Bindings::storage_buffer(Slot slot, const Buffer& buffer) {
  require_same_device(state_->device, buffer.state()->device);
  state_->slot(slot, vk::DescriptorType::eStorageBuffer).buffer = buffer.state();
}

void Bindings::sampled_image(Slot slot, const Image& image) {
  require_same_device(state_->device, image.state()->device);
  state_->slot(slot, vk::DescriptorType::eSampledImage).image = image.state();
}

void Bindings::storage_image(Slot slot, const Image& image) {
  require_same_device(state_->device, image.state()->device);
  if (is_depth(image.format())) throw std::logic_error("a depth image cannot be a storage image");
  state_->slot(slot, vk::DescriptorType::eStorageImage).image = image.state();
}

void Bindings::sampler(Slot slot, const Sampler& sampler) {
  require_same_device(state_->device, sampler.state()->device);
  state_->slot(slot, vk::DescriptorType::eSampler).sampler = sampler.state();
}

void Bindings::uniform_bytes(Slot slot, std::span<const std::byte> bytes) {
  if (bytes.empty()) throw std::invalid_argument("a uniform block of 0 bytes");
  const bool was_changed = state_->changed;
  BoundResource& bound = state_->slot(slot, vk::DescriptorType::eUniformBuffer);
  if (bound.uniforms.bytes == bytes.size()) {
    state_->changed = was_changed;  // same buffer, new content: descriptors stay as they are
  } else {
    guarded(*state_->device, "make a uniform buffer", [&] {
      bound.uniforms = state_->device->make_buffer(
          bytes.size(), vk::BufferUsageFlagBits::eUniformBuffer,
          vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent);
    });
  }
  std::memcpy(bound.uniforms.mapped, bytes.data(), bytes.size());
}

BoundResource& BindingsState::slot(Slot slot, vk::DescriptorType type) {
  const auto [at, is_new] = slots.try_emplace({slot.set, slot.binding});
  if (is_new && frozen()) {
    slots.erase(at);
    throw std::logic_error(place(slot.set, slot.binding) + " was first bound after the pass had run");
  }
  if (is_new) at->second.type = type;
  if (at->second.type != type) {
    throw std::logic_error(place(slot.set, slot.binding) + " holds " + vk::to_string(at->second.type) +
                           ", not " + vk::to_string(type));
  }
  changed = true;
  return at->second;
}

void BindingsState::freeze(vk::ShaderStageFlags stages, std::uint32_t push_constant_bytes) {
  std::map<std::uint32_t, std::vector<vk::DescriptorSetLayoutBinding>> by_set;
  std::map<vk::DescriptorType, std::uint32_t> counts;
  for (const auto& [place_of, bound] : slots) {
    by_set[place_of.first].emplace_back(place_of.second, bound.type, 1, stages);
    ++counts[bound.type];
  }
  const std::uint32_t set_count = by_set.empty() ? 0 : by_set.rbegin()->first + 1;
  std::vector<vk::DescriptorSetLayout> handles;
  for (std::uint32_t set = 0; set < set_count; ++set) {
    layouts.emplace_back(device->device, vk::DescriptorSetLayoutCreateInfo({}, by_set[set]));
    handles.push_back(*layouts.back());
  }
  if (set_count > 0) {
    std::vector<vk::DescriptorPoolSize> sizes;
    sizes.reserve(counts.size());
    for (const auto& [type, count] : counts) sizes.emplace_back(type, count);
    pool = vk::raii::DescriptorPool(
        device->device,
        vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, set_count, sizes));
    sets = vk::raii::DescriptorSets(device->device, vk::DescriptorSetAllocateInfo(*pool, handles));
  }
  const vk::PushConstantRange range(stages, 0, push_constant_bytes);
  vk::PipelineLayoutCreateInfo create({}, handles);
  if (push_constant_bytes > 0) create.setPushConstantRanges(range);
  pipeline_layout = vk::raii::PipelineLayout(device->device, create);
}

void BindingsState::write_descriptors() {
  if (!changed) return;
  for (const auto& [place_of, bound] : slots) {
    vk::DescriptorBufferInfo buffer({}, 0, VK_WHOLE_SIZE);
    vk::DescriptorImageInfo image;
    vk::WriteDescriptorSet write(*sets[place_of.first], place_of.second, 0, 1, bound.type);
    if (bound.buffer) buffer.buffer = *bound.buffer->allocation.buffer;
    if (bound.uniforms.bytes > 0) buffer.buffer = *bound.uniforms.buffer;
    if (bound.image) {
      image.imageView = *bound.image->shader_view;
      image.imageLayout = layout_for(bound.type);
    }
    if (bound.sampler) image.sampler = *bound.sampler->sampler;
    if (buffer.buffer) {
      write.pBufferInfo = &buffer;
    } else {
      write.pImageInfo = &image;
    }
    device->device.updateDescriptorSets(write, nullptr);
  }
  changed = false;
}

void BindingsState::use(vk::PipelineBindPoint point, const vk::raii::CommandBuffer& commands) {
  for (const auto& [place_of, bound] : slots) {
    if (bound.image) bound.image->move_to(layout_for(bound.type), commands);
  }
  std::vector<vk::DescriptorSet> handles;
  for (const vk::raii::DescriptorSet& set : sets) handles.push_back(*set);
  if (!handles.empty()) commands.bindDescriptorSets(point, *pipeline_layout, 0, handles, nullptr);
}

}  // namespace penumbra::gpu
