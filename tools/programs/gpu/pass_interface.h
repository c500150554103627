// The resources that a pass's modules read and write, by name, and the layouts that follow from them.
// Internal to this folder.
#pragma once

#include "gpu/device_state.h"
#include "shaders/reflect.h"

namespace penumbra::gpu {

// A resource of one stage. Two stages of a pass may have resources of the same name.
struct InterfaceSlot {
  shaders::Resource resource;
  std::uint32_t set = 0;
  vk::DescriptorType type = vk::DescriptorType::eStorageBuffer;
  vk::ShaderStageFlagBits stage = vk::ShaderStageFlagBits::eCompute;
};

struct PassInterface {
  std::shared_ptr<DeviceState> device;
  std::vector<InterfaceSlot> slots;
  std::vector<vk::raii::DescriptorSetLayout> layouts;  // one for each set, gaps included
  vk::ShaderStageFlags stages;                         // the stages that read the push constants
  vk::raii::PipelineLayout pipeline_layout = nullptr;
};

struct StageModule {
  std::vector<std::uint32_t> spirv;
  vk::ShaderStageFlagBits stage = vk::ShaderStageFlagBits::eCompute;
};

// Each module numbers its own bindings: the later ones' sets are moved behind those of the first.
std::shared_ptr<PassInterface> make_interface(const std::shared_ptr<DeviceState>& device,
                                              std::vector<StageModule>& modules,
                                              std::uint32_t push_constant_bytes);

}  // namespace penumbra::gpu
