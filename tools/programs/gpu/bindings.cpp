#include "gpu/bindings.h"

#include <cstring>
#include <map>
#include <stdexcept>

#include "gpu/pass_state.h"

namespace penumbra::gpu {
namespace {

using shaders::ResourceKind;

bool is_image(ResourceKind kind) {
  return kind == ResourceKind::sampled_image || kind == ResourceKind::storage_image;
}

vk::ImageLayout layout_of(ResourceKind kind) {
  return kind == ResourceKind::storage_image ? vk::ImageLayout::eGeneral
                                             : vk::ImageLayout::eShaderReadOnlyOptimal;
}

vk::ImageViewType view_type(const shaders::ImageType& type) {
  if (type.dimensions == 3) return vk::ImageViewType::e3D;
  if (type.cube) return type.arrayed ? vk::ImageViewType::eCubeArray : vk::ImageViewType::eCube;
  return type.arrayed ? vk::ImageViewType::e2DArray : vk::ImageViewType::e2D;
}

// Calls `put` for the slots of that name; std::logic_error when `fits` is true for none.
template <typename Fits, typename Put>
void for_slots(BindingsState& state, const std::string& name, const char* what, Fits fits, Put put) {
  bool found = false;
  for (std::size_t i = 0; i < state.interface->slots.size(); ++i) {
    const InterfaceSlot& slot = state.interface->slots[i];
    if (slot.resource.name != name) continue;
    if (!fits(slot))
      throw std::logic_error("'" + name + "' is " + vk::to_string(slot.type) + " and not " + what);
    put(slot, state.bound[i]);
    found = true;
  }
  if (!found) throw std::logic_error("the shaders of the pass read no '" + name + "'");
}

// The same, for a resource of that device instead of the one before.
template <typename Fits, typename Put>
void replace_in_slots(BindingsState& state, const std::shared_ptr<DeviceState>& device,
                      const std::string& name, const char* what, Fits fits, Put put) {
  if (state.interface->device != device) throw std::logic_error("a resource of another device is bound");
  for_slots(state, name, what, fits, put);
  state.changed = true;
  ++state.revision;
}

ImageParts parts_of(const Image& image, ImageRange range, ResourceKind kind) {
  const ImageShape& shape = image.shape();
  ImageParts parts{range.first_mip, range.mips > 0 ? range.mips : shape.mips - range.first_mip,
                   range.first_layer, range.layers > 0 ? range.layers : shape.layers - range.first_layer};
  if (kind == ResourceKind::storage_image) parts.mips = 1;
  if (parts.first_mip < 0 || parts.mips < 1 || parts.first_mip + parts.mips > shape.mips ||
      parts.first_layer < 0 || parts.layers < 1 || parts.first_layer + parts.layers > shape.layers)
    throw std::invalid_argument("a range of mip levels or layers that the image does not have");
  return parts;
}

void check_shape(const InterfaceSlot& slot, const Image& image, const ImageParts& parts) {
  const shaders::ImageType& type = slot.resource.image;
  const ImageShape& shape = image.shape();
  const bool is_3d = shape.depth > 1 || (type.dimensions == 3 && shape.layers == 1);
  const std::string name = "'" + slot.resource.name + "'";
  if (is_3d != (type.dimensions == 3)) throw std::logic_error(name + " and its image differ in dimensions");
  if ((shape.samples > 1) != type.multisampled)
    throw std::logic_error(name + " and its image differ in samples");
  if (parts.layers > 1 && !type.arrayed)
    throw std::logic_error(name + " is no array, and its image has layers");
  if (slot.resource.kind != ResourceKind::storage_image) return;
  if (is_depth(shape.format)) throw std::logic_error("a depth image cannot be a storage image");
  if (!(image.state()->texel.usage & vk::ImageUsageFlagBits::eStorage))
    throw EnvironmentError(image.state()->device->info.name + ": shaders cannot write " +
                           gpu::name(shape.format) + " images here");
}

}  // namespace

Bindings::Bindings(std::shared_ptr<PassInterface> interface) : state_(std::make_shared<BindingsState>()) {
  state_->bound.resize(interface->slots.size());
  state_->interface = std::move(interface);
}

bool Bindings::has(const std::string& name) const {
  for (const InterfaceSlot& slot : state_->interface->slots)
    if (slot.resource.name == name) return true;
  return false;
}

void Bindings::buffer(const std::string& name, const Buffer& buffer) {
  replace_in_slots(
      *state_, buffer.state()->device, name, "a buffer",
      [](const InterfaceSlot& slot) { return slot.resource.kind == ResourceKind::storage_buffer; },
      [&](const InterfaceSlot&, BoundResource& bound) { bound.buffer = buffer.state(); });
}

void Bindings::image(const std::string& name, const Image& image, ImageRange range) {
  replace_in_slots(
      *state_, image.state()->device, name, "an image",
      [](const InterfaceSlot& slot) { return is_image(slot.resource.kind); },
      [&](const InterfaceSlot& slot, BoundResource& bound) {
        const ImageParts parts = parts_of(image, range, slot.resource.kind);
        check_shape(slot, image, parts);
        bound.image = image.state();
        bound.parts = parts;
      });
}

void Bindings::sampler(const std::string& name, const Sampler& sampler) {
  replace_in_slots(
      *state_, sampler.state()->device, name, "a sampler",
      [](const InterfaceSlot& slot) { return slot.resource.kind == ResourceKind::sampler; },
      [&](const InterfaceSlot&, BoundResource& bound) { bound.sampler = sampler.state(); });
}

void Bindings::uniform_bytes(const std::string& name, std::span<const std::byte> bytes) {
  if (bytes.empty()) throw std::invalid_argument("a uniform block of 0 bytes");
  DeviceState& device = *state_->interface->device;
  for_slots(
      *state_, name, "a uniform block",
      [](const InterfaceSlot& slot) { return slot.resource.kind == ResourceKind::uniform_block; },
      [&](const InterfaceSlot& slot, BoundResource& bound) {
        if (bytes.size() < slot.resource.size)
          throw std::logic_error(std::to_string(bytes.size()) + " bytes are bound to '" + name +
                                 "', which has " + std::to_string(slot.resource.size));
        if (!bound.uniforms || bound.uniforms->bytes != bytes.size()) {
          guarded(device, "make a uniform buffer", [&] {
            bound.uniforms = std::make_shared<Allocation>(device.make_buffer(
                bytes.size(), vk::BufferUsageFlagBits::eUniformBuffer,
                vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent));
          });
          state_->changed = true;
        }
        std::memcpy(bound.uniforms->mapped, bytes.data(), bytes.size());
      });
}

void BindingsState::require_bound() const {
  for (std::size_t i = 0; i < bound.size(); ++i)
    if (bound[i].empty())
      throw std::logic_error("nothing is bound to '" + interface->slots[i].resource.name + "'");
}

void BindingsState::make_sets() {
  std::map<vk::DescriptorType, std::uint32_t> counts;
  for (const InterfaceSlot& slot : interface->slots) ++counts[slot.type];
  std::vector<vk::DescriptorPoolSize> sizes;
  for (const auto& [type, count] : counts) sizes.emplace_back(type, count);
  std::vector<vk::DescriptorSetLayout> layouts;
  for (const vk::raii::DescriptorSetLayout& layout : interface->layouts) layouts.push_back(*layout);
  const vk::raii::Device& device = interface->device->device;
  pool = vk::raii::DescriptorPool(
      device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                           std::uint32_t(layouts.size()), sizes));
  sets = vk::raii::DescriptorSets(device, vk::DescriptorSetAllocateInfo(*pool, layouts));
}

void BindingsState::write_descriptors() {
  if (!changed || interface->slots.empty()) return;
  if (sets.empty()) make_sets();
  for (std::size_t i = 0; i < bound.size(); ++i) {
    const InterfaceSlot& slot = interface->slots[i];
    BoundResource& one = bound[i];
    vk::DescriptorBufferInfo buffer({}, 0, VK_WHOLE_SIZE);
    vk::DescriptorImageInfo image;
    vk::WriteDescriptorSet write(*sets[slot.set], slot.resource.binding, 0, 1, slot.type);
    if (one.buffer) buffer.buffer = *one.buffer->allocation.buffer;
    if (one.uniforms) buffer.buffer = *one.uniforms->buffer;
    if (one.image) {
      image.imageView = one.image->view(one.parts, view_type(slot.resource.image), false);
      image.imageLayout = layout_of(slot.resource.kind);
    }
    if (one.sampler) image.sampler = *one.sampler->sampler;
    if (buffer.buffer) {
      write.pBufferInfo = &buffer;
    } else {
      write.pImageInfo = &image;
    }
    interface->device->device.updateDescriptorSets(write, nullptr);
  }
  changed = false;
}

void BindingsState::use(vk::PipelineBindPoint point, const vk::raii::CommandBuffer& commands) const {
  std::vector<vk::DescriptorSet> handles;
  for (const vk::raii::DescriptorSet& set : sets) handles.push_back(*set);
  if (!handles.empty()) commands.bindDescriptorSets(point, *interface->pipeline_layout, 0, handles, nullptr);
}

void BindingsState::add_uses(ResourceUses& uses) const {
  for (std::size_t i = 0; i < bound.size(); ++i) {
    const InterfaceSlot& slot = interface->slots[i];
    Access access;
    access.stages = slot.stage == vk::ShaderStageFlagBits::eVertex ? vk::PipelineStageFlagBits::eVertexShader
                    : slot.stage == vk::ShaderStageFlagBits::eFragment
                        ? vk::PipelineStageFlagBits::eFragmentShader
                        : vk::PipelineStageFlagBits::eComputeShader;
    access.access = vk::AccessFlagBits::eShaderRead;
    access.writes = slot.resource.written;
    if (access.writes) access.access |= vk::AccessFlagBits::eShaderWrite;
    if (bound[i].buffer) uses.buffers.push_back({bound[i].buffer, access});
    if (bound[i].image)
      uses.images.push_back({bound[i].image, bound[i].parts, layout_of(slot.resource.kind), access});
  }
}

}  // namespace penumbra::gpu
