// Which platforms a list of targets is compiled for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shaders/vulkan_version.h"
#include "variants/platform_defines.h"

namespace penumbra::validation {

// One graphics API and what is made for it: sources are compiled once for each platform, with the macros
// Unity defines there.
struct PlatformTargets {
  variants::Platform platform;
  std::vector<std::string> targets;
  shaders::VulkanVersion vulkan = shaders::VulkanVersion::v1_1;  // of the modules they are made from
};

struct PlatformChoice {
  std::optional<variants::GraphicsApi> api;  // of all targets; absent: each target's own
  bool mobile = false;                       // always true for OpenGL ES
  int unity_version = variants::Platform().unity_version;
};

// In the order of the graphics APIs, then of the Vulkan versions.
std::vector<PlatformTargets> platform_targets(const std::vector<std::string>& targets,
                                              const PlatformChoice& choice);

}  // namespace penumbra::validation
