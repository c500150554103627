// The platforms for which a list of targets is compiled.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shaders/vulkan_version.h"
#include "variants/platform_defines.h"

namespace penumbra::validation {

// One graphics API and its targets: sources are compiled once for each platform, with the macros that Unity
// defines there.
struct PlatformTargets {
  variants::Platform platform;
  std::vector<std::string> targets;
  // The version of the modules from which the targets are made.
  shaders::VulkanVersion vulkan = shaders::VulkanVersion::v1_1;
};

struct PlatformChoice {
  std::optional<variants::GraphicsApi> api;  // API of all targets; if absent, each target has its own
  bool mobile = false;                       // always true for OpenGL ES
  int unity_version = variants::Platform().unity_version;
};

// Returns the platforms in the order of the graphics APIs, then of the Vulkan versions.
std::vector<PlatformTargets> platform_targets(const std::vector<std::string>& targets,
                                              const PlatformChoice& choice);

}  // namespace penumbra::validation
