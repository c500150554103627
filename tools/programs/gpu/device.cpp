#include "gpu/device.h"

#include "gpu/device_state.h"
#include "gpu/instance.h"
#include "gpu/texel_format.h"

namespace penumbra::gpu {
namespace {

// Vulkan 1.1 has 16-bit storage; 16-bit arithmetic is an extension of it.
struct HalfFeatures {
  vk::PhysicalDevice16BitStorageFeatures storage;
  vk::PhysicalDeviceShaderFloat16Int8FeaturesKHR arithmetic;

  explicit HalfFeatures(const vk::raii::PhysicalDevice& physical) {
    const auto offered =
        physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDevice16BitStorageFeatures,
                              vk::PhysicalDeviceShaderFloat16Int8FeaturesKHR>();
    storage.storageBuffer16BitAccess =
        offered.get<vk::PhysicalDevice16BitStorageFeatures>().storageBuffer16BitAccess;
    const bool has =
        offers(physical.enumerateDeviceExtensionProperties(), VK_KHR_SHADER_FLOAT16_INT8_EXTENSION_NAME);
    arithmetic.shaderFloat16 =
        has && offered.get<vk::PhysicalDeviceShaderFloat16Int8FeaturesKHR>().shaderFloat16;
  }
};

SubgroupInfo subgroup_of(const vk::raii::PhysicalDevice& physical) {
  using Feature = vk::SubgroupFeatureFlagBits;
  const auto properties =
      physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceSubgroupProperties>()
          .get<vk::PhysicalDeviceSubgroupProperties>();
  SubgroupInfo info;
  info.lanes = static_cast<int>(properties.subgroupSize);
  if (!(properties.supportedStages & vk::ShaderStageFlagBits::eCompute)) return info;
  info.vote = bool(properties.supportedOperations & Feature::eVote);
  info.arithmetic = bool(properties.supportedOperations & Feature::eArithmetic);
  info.ballot = bool(properties.supportedOperations & Feature::eBallot);
  info.shuffle = bool(properties.supportedOperations & Feature::eShuffle);
  info.quad = bool(properties.supportedOperations & Feature::eQuad);
  return info;
}

// These extensions make depths outside [0, 1] and NaN texels legal, and a portability driver requires them.
std::vector<const char*> device_extensions(const vk::raii::PhysicalDevice& physical) {
  const std::vector<vk::ExtensionProperties> offered = physical.enumerateDeviceExtensionProperties();
  std::vector<const char*> enabled;
  for (const char* wanted : {VK_EXT_DEPTH_RANGE_UNRESTRICTED_EXTENSION_NAME, "VK_KHR_portability_subset",
                             VK_KHR_SHADER_FLOAT16_INT8_EXTENSION_NAME}) {
    if (offers(offered, wanted)) enabled.push_back(wanted);
  }
  return enabled;
}

void open_device(DeviceState& state) {
  const vk::PhysicalDeviceFeatures offered = state.physical.getFeatures();
  state.features.depthClamp = offered.depthClamp;
  state.features.shaderImageGatherExtended = offered.shaderImageGatherExtended;
  state.features.shaderStorageImageExtendedFormats = offered.shaderStorageImageExtendedFormats;
  state.features.shaderStorageImageReadWithoutFormat = offered.shaderStorageImageReadWithoutFormat;
  state.features.shaderStorageImageWriteWithoutFormat = offered.shaderStorageImageWriteWithoutFormat;
  state.features.vertexPipelineStoresAndAtomics = offered.vertexPipelineStoresAndAtomics;
  state.features.fragmentStoresAndAtomics = offered.fragmentStoresAndAtomics;
  state.features.sampleRateShading = offered.sampleRateShading;
  state.features.independentBlend = offered.independentBlend;
  state.features.shaderInt16 = offered.shaderInt16;
  state.features.shaderFloat64 = offered.shaderFloat64;
  state.features.shaderInt64 = offered.shaderInt64;
  state.limits = state.physical.getProperties().limits;
  const std::uint32_t bits = state.physical.getQueueFamilyProperties()[state.queue_family].timestampValidBits;
  state.timestamp_mask = bits == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << bits) - 1;

  const float priority = 1.0F;
  const vk::DeviceQueueCreateInfo queue({}, state.queue_family, 1, &priority);
  const std::vector<const char*> extensions = device_extensions(state.physical);
  HalfFeatures half(state.physical);
  state.info.half_arithmetic = half.arithmetic.shaderFloat16;
  state.info.half_storage = half.storage.storageBuffer16BitAccess;
  state.info.subgroup = subgroup_of(state.physical);
  vk::DeviceCreateInfo create({}, queue, {}, extensions, &state.features);
  // With this feature a vertex program of translated Direct3D bytecode counts instances from 0.
  auto draws =
      state.physical
          .getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceShaderDrawParametersFeatures>()
          .get<vk::PhysicalDeviceShaderDrawParametersFeatures>();
  draws.pNext = nullptr;
  half.arithmetic.pNext = &draws;
  half.storage.pNext = half.arithmetic.shaderFloat16 ? static_cast<void*>(&half.arithmetic) : &draws;
  create.pNext = &half.storage;
  state.device = vk::raii::Device(state.physical, create);
  state.queue = state.device.getQueue(state.queue_family, 0);
  state.command_pool = vk::raii::CommandPool(
      state.device, {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, state.queue_family});
  vk::raii::CommandBuffers buffers(state.device, {*state.command_pool, vk::CommandBufferLevel::ePrimary, 1});
  state.commands = std::move(buffers.front());
  state.fence = vk::raii::Fence(state.device, vk::FenceCreateInfo());
}

}  // namespace

std::vector<DeviceInfo> list_devices() {
  const vk::raii::Context context = load_vulkan();
  return starting_vulkan([&context] {
    const vk::raii::Instance instance = make_instance(context, nullptr);
    std::vector<DeviceInfo> infos;
    for (const Candidate& candidate : candidates_of(instance)) infos.push_back(candidate.info);
    return infos;
  });
}

Device::Device(const DeviceOptions& options) : state_(std::make_shared<DeviceState>(load_vulkan())) {
  state_->timeout_seconds = options.timeout_seconds;
  MessageLog* log = options.validation ? state_->log.get() : nullptr;
  Candidate chosen = starting_vulkan([this, log, &options] {
    state_->instance = make_instance(state_->context, log);
    if (log != nullptr)
      state_->messenger = vk::raii::DebugUtilsMessengerEXT(state_->instance, messenger_of(*log));
    return choose(candidates_of(state_->instance), options.name);
  });
  state_->physical = std::move(chosen.physical);
  state_->queue_family = chosen.queue_family;
  state_->info = std::move(chosen.info);
  guarded(*state_, "open the device", [this] { open_device(*state_); });
}

Device::~Device() {
  if (state_) state_->release_stuck();
}

Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;

const DeviceInfo& Device::info() const {
  return state_->info;
}

bool Device::supports(Format format) const {
  return texel_format_of(*state_, format).has_value();
}

FormatUses Device::uses(Format format) const {
  return uses_of(*state_, format);
}

std::shared_ptr<const ValidationLog> Device::validation_log() const {
  return state_->log;
}

}  // namespace penumbra::gpu
