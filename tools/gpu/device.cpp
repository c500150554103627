#include "gpu/device.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "gpu/device_state.h"
#include "gpu/texel_format.h"

namespace penumbra::gpu {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";
constexpr std::uint32_t wanted_api = VK_API_VERSION_1_1;
constexpr vk::QueueFlags wanted_queue = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;

VKAPI_ATTR VkBool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT /*severity*/,
                                       VkDebugUtilsMessageTypeFlagsEXT /*type*/,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void* log) {
  static_cast<MessageLog*>(log)->add(data->pMessage);
  return VK_FALSE;
}

vk::DebugUtilsMessengerCreateInfoEXT messenger_of(MessageLog& log) {
  using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
  using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
  return {{}, Severity::eWarning | Severity::eError, Type::eValidation | Type::ePerformance, collect, &log};
}

vk::raii::Context load_vulkan() {
  try {
    return vk::raii::Context();
  } catch (const std::exception& error) {
    throw EnvironmentError(std::string("no Vulkan loader: ") + error.what() +
                           "\n  scripts/setup installs one (Debian: libvulkan1 mesa-vulkan-drivers)");
  }
}

bool offers(const std::vector<vk::ExtensionProperties>& extensions, std::string_view name) {
  return std::any_of(extensions.begin(), extensions.end(), [name](const vk::ExtensionProperties& extension) {
    return std::string_view(extension.extensionName) == name;
  });
}

void require_validation_layer(const vk::raii::Context& context) {
  for (const vk::LayerProperties& layer : context.enumerateInstanceLayerProperties()) {
    if (std::string_view(layer.layerName) == validation_layer) return;
  }
  throw EnvironmentError(std::string(validation_layer) +
                         " is not installed\n  scripts/setup installs it (Debian: vulkan-validationlayers)");
}

// `log` asks for validation; null means without.
vk::raii::Instance make_instance(const vk::raii::Context& context, MessageLog* log) {
  const vk::ApplicationInfo application("penumbra", 1, "penumbra", 1, wanted_api);
  std::vector<const char*> layers;
  std::vector<const char*> extensions;
  vk::InstanceCreateInfo create({}, &application);
  if (offers(context.enumerateInstanceExtensionProperties(), VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME)) {
    extensions.push_back(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME);
    create.flags |= vk::InstanceCreateFlagBits::eEnumeratePortabilityKHR;
  }
  vk::DebugUtilsMessengerCreateInfoEXT messenger;
  if (log != nullptr) {
    require_validation_layer(context);
    layers.push_back(validation_layer);
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    messenger = messenger_of(*log);
    create.pNext = &messenger;  // hears of what the instance's own creation and destruction do
  }
  create.setPEnabledLayerNames(layers);
  create.setPEnabledExtensionNames(extensions);
  return {context, create};
}

// Runs what happens before there is a device to name in the error.
template <typename Action>
auto starting_vulkan(Action&& action) {
  try {
    return action();
  } catch (const vk::SystemError& error) {
    throw EnvironmentError(std::string("Vulkan does not start: ") + error.what() +
                           "\n  a driver is missing; scripts/setup installs the software device "
                           "(Debian: mesa-vulkan-drivers)");
  }
}

std::optional<std::uint32_t> queue_family_of(const vk::raii::PhysicalDevice& physical) {
  const std::vector<vk::QueueFamilyProperties> families = physical.getQueueFamilyProperties();
  for (std::uint32_t family = 0; family < families.size(); ++family) {
    if ((families[family].queueFlags & wanted_queue) == wanted_queue) return family;
  }
  return std::nullopt;
}

std::string version_text(std::uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) +
         "." + std::to_string(VK_API_VERSION_PATCH(version));
}

DeviceInfo describe(const vk::raii::PhysicalDevice& physical, int index, std::uint32_t family) {
  const vk::PhysicalDeviceProperties properties = physical.getProperties();
  DeviceInfo info;
  info.index = index;
  info.name = std::string(std::string_view(properties.deviceName));
  info.api_version = version_text(properties.apiVersion);
  info.is_software = properties.deviceType == vk::PhysicalDeviceType::eCpu;
  // A software device (lavapipe) stamps the time when it hands work to its threads, not when they have done
  // it.
  info.has_timestamps =
      !info.is_software && physical.getQueueFamilyProperties()[family].timestampValidBits > 0;
  info.driver = version_text(properties.driverVersion);
  // Only valid where the extension became core; older drivers keep the bare version.
  if (properties.apiVersion >= VK_API_VERSION_1_2) {
    const auto chain =
        physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
    info.driver = std::string(std::string_view(driver.driverName)) + " " +
                  std::string(std::string_view(driver.driverInfo));
  }
  return info;
}

struct Candidate {
  vk::raii::PhysicalDevice physical;
  std::uint32_t queue_family;
  DeviceInfo info;
};

std::vector<Candidate> candidates_of(const vk::raii::Instance& instance) {
  std::vector<Candidate> candidates;
  for (vk::raii::PhysicalDevice& physical : vk::raii::PhysicalDevices(instance)) {
    const std::optional<std::uint32_t> family = queue_family_of(physical);
    if (!family || physical.getProperties().apiVersion < wanted_api) continue;
    DeviceInfo info = describe(physical, static_cast<int>(candidates.size()), *family);
    candidates.push_back({std::move(physical), *family, std::move(info)});
  }
  if (candidates.empty()) {
    throw EnvironmentError(
        "Vulkan has no device with graphics and compute\n  scripts/setup installs the software device "
        "(Debian: mesa-vulkan-drivers)");
  }
  return candidates;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

bool answers_to(const DeviceInfo& info, const std::string& wanted) {
  int index = 0;
  const char* end = wanted.data() + wanted.size();
  const auto [rest, error] = std::from_chars(wanted.data(), end, index);
  if (error == std::errc() && rest == end) return info.index == index;
  return lower_case(info.name).find(lower_case(wanted)) != std::string::npos;
}

Candidate choose(std::vector<Candidate> candidates, const std::string& wanted) {
  const auto chosen =
      std::find_if(candidates.begin(), candidates.end(), [&wanted](const Candidate& candidate) {
        return wanted.empty() ? candidate.info.is_software : answers_to(candidate.info, wanted);
      });
  if (chosen != candidates.end()) return std::move(*chosen);
  if (wanted.empty()) return std::move(candidates.front());
  std::string known;
  for (const Candidate& candidate : candidates) {
    known += "\n  " + std::to_string(candidate.info.index) + ": " + candidate.info.name;
  }
  throw EnvironmentError("no Vulkan device '" + wanted + "'; there are" + known);
}

// What makes depths outside [0, 1] and NaN texels legal, and what a portability driver insists on.
std::vector<const char*> device_extensions(const vk::raii::PhysicalDevice& physical) {
  const std::vector<vk::ExtensionProperties> offered = physical.enumerateDeviceExtensionProperties();
  std::vector<const char*> enabled;
  for (const char* wanted : {VK_EXT_DEPTH_RANGE_UNRESTRICTED_EXTENSION_NAME, "VK_KHR_portability_subset"}) {
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
  state.features.shaderFloat64 = offered.shaderFloat64;
  state.features.shaderInt64 = offered.shaderInt64;
  state.limits = state.physical.getProperties().limits;
  const std::uint32_t bits = state.physical.getQueueFamilyProperties()[state.queue_family].timestampValidBits;
  state.timestamp_mask = bits == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << bits) - 1;

  const float priority = 1.0F;
  const vk::DeviceQueueCreateInfo queue({}, state.queue_family, 1, &priority);
  const std::vector<const char*> extensions = device_extensions(state.physical);
  state.device =
      vk::raii::Device(state.physical, vk::DeviceCreateInfo({}, queue, {}, extensions, &state.features));
  state.queue = state.device.getQueue(state.queue_family, 0);
  state.command_pool = vk::raii::CommandPool(
      state.device, {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, state.queue_family});
  vk::raii::CommandBuffers buffers(state.device, {*state.command_pool, vk::CommandBufferLevel::ePrimary, 1});
  state.commands = std::move(buffers.front());
  state.fence = vk::raii::Fence(state.device, vk::FenceCreateInfo());
  state.timestamps =
      vk::raii::QueryPool(state.device, vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, 2));
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
    if (log != nullptr) {
      state_->messenger = vk::raii::DebugUtilsMessengerEXT(state_->instance, messenger_of(*log));
    }
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

std::shared_ptr<const ValidationLog> Device::validation_log() const {
  return state_->log;
}

}  // namespace penumbra::gpu
