// The steps from the Vulkan loader to a physical device, for this folder's sources only.
#pragma once

#include <string>
#include <string_view>

#include "gpu/device_state.h"

namespace penumbra::gpu {

// Throws EnvironmentError when there is no loader.
vk::raii::Context load_vulkan();

// With a `log` the instance has validation; null means without.
vk::raii::Instance make_instance(const vk::raii::Context& context, MessageLog* log);
vk::DebugUtilsMessengerCreateInfoEXT messenger_of(MessageLog& log);

struct Candidate {
  vk::raii::PhysicalDevice physical;
  std::uint32_t queue_family;
  DeviceInfo info;
};

// Returns all devices with Vulkan 1.1 and a queue for graphics and compute; throws EnvironmentError when
// there is none.
std::vector<Candidate> candidates_of(const vk::raii::Instance& instance);

// Returns the device that `wanted` names, as DeviceOptions::name says; throws EnvironmentError naming all
// when none does.
Candidate choose(std::vector<Candidate> candidates, const std::string& wanted);

bool offers(const std::vector<vk::ExtensionProperties>& extensions, std::string_view name);

// Runs an action before there is a device that an error could name.
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

}  // namespace penumbra::gpu
