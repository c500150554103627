// The targets that are the SPIR-V itself: "vulkan1.0", "vulkan1.1" and "vulkan1.2", compiled and validated
// for that version, and "spirv", which is for 1.1. "d3d11" is FXC's bytecode, made of the same text by
// another compiler (fxc/judge.h). All other targets are made from a module for 1.1.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shaders/vulkan_version.h"

namespace penumbra::validation {

std::vector<std::string> spirv_targets();  // the names of these targets
std::optional<shaders::VulkanVersion> spirv_target(std::string_view target);
inline bool is_spirv_target(std::string_view target) {
  return spirv_target(target).has_value();
}

inline constexpr std::string_view fxc_target = "d3d11";

// Returns whether the text itself is compiled for a target; the others are made from a module.
inline bool is_compiled_target(std::string_view target) {
  return target == fxc_target || is_spirv_target(target);
}

// Returns the targets of each compilation, in the order in which they were given. A compilation serves one
// version, or FXC.
std::vector<std::pair<shaders::VulkanVersion, std::vector<std::string>>> by_vulkan_version(
    const std::vector<std::string>& targets);

}  // namespace penumbra::validation
