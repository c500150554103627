#include "gpu/instance.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>

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

void require_validation_layer(const vk::raii::Context& context) {
  for (const vk::LayerProperties& layer : context.enumerateInstanceLayerProperties()) {
    if (std::string_view(layer.layerName) == validation_layer) return;
  }
  throw EnvironmentError(std::string(validation_layer) +
                         " is not installed\n  scripts/setup installs it (Debian: vulkan-validationlayers)");
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
  // The property is valid only where the extension became core; older drivers keep the bare version.
  if (properties.apiVersion >= VK_API_VERSION_1_2) {
    const auto chain =
        physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
    info.driver = std::string(std::string_view(driver.driverName)) + " " +
                  std::string(std::string_view(driver.driverInfo));
  }
  return info;
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

}  // namespace

vk::raii::Context load_vulkan() {
  try {
    return vk::raii::Context();
  } catch (const std::exception& error) {
    throw EnvironmentError(std::string("no Vulkan loader: ") + error.what() +
                           "\n  scripts/setup installs one (Debian: libvulkan1 mesa-vulkan-drivers)");
  }
}

vk::DebugUtilsMessengerCreateInfoEXT messenger_of(MessageLog& log) {
  using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
  using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
  return {{}, Severity::eWarning | Severity::eError, Type::eValidation | Type::ePerformance, collect, &log};
}

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
  const std::array checked{vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
  vk::ValidationFeaturesEXT features(checked);
  if (log != nullptr) {
    require_validation_layer(context);
    layers.push_back(validation_layer);
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    messenger = messenger_of(*log);
    messenger.pNext = &features;
    create.pNext = &messenger;  // receives messages about the instance's own creation and destruction
  }
  create.setPEnabledLayerNames(layers);
  create.setPEnabledExtensionNames(extensions);
  return {context, create};
}

bool offers(const std::vector<vk::ExtensionProperties>& extensions, std::string_view name) {
  return std::any_of(extensions.begin(), extensions.end(), [name](const vk::ExtensionProperties& extension) {
    return std::string_view(extension.extensionName) == name;
  });
}

std::vector<Candidate> candidates_of(const vk::raii::Instance& instance) {
  std::vector<Candidate> candidates;
  for (vk::raii::PhysicalDevice& physical : vk::raii::PhysicalDevices(instance)) {
    const std::optional<std::uint32_t> family = queue_family_of(physical);
    if (!family || physical.getProperties().apiVersion < wanted_api) continue;
    DeviceInfo info = describe(physical, static_cast<int>(candidates.size()), *family);
    candidates.push_back({std::move(physical), *family, std::move(info)});
  }
  if (candidates.empty())
    throw EnvironmentError(
        "Vulkan has no device with graphics and compute\n  scripts/setup installs the software device "
        "(Debian: mesa-vulkan-drivers)");
  return candidates;
}

Candidate choose(std::vector<Candidate> candidates, const std::string& wanted) {
  const auto chosen =
      std::find_if(candidates.begin(), candidates.end(), [&wanted](const Candidate& candidate) {
        return wanted.empty() ? candidate.info.is_software : answers_to(candidate.info, wanted);
      });
  if (chosen != candidates.end()) return std::move(*chosen);
  if (wanted.empty()) return std::move(candidates.front());
  std::string known;
  for (const Candidate& candidate : candidates)
    known += "\n  " + std::to_string(candidate.info.index) + ": " + candidate.info.name;
  throw EnvironmentError("no Vulkan device '" + wanted + "'; there are" + known);
}

}  // namespace penumbra::gpu
