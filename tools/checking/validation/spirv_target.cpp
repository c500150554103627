#include "validation/spirv_target.h"

#include <algorithm>

namespace penumbra::validation {

namespace {

std::string name_for(shaders::VulkanVersion version) {
  return std::string("vulkan") + shaders::vulkan_version_name(version);
}

}  // namespace

std::vector<std::string> spirv_targets() {
  std::vector<std::string> names{"spirv"};
  for (const shaders::VulkanVersion version : shaders::all_vulkan_versions)
    names.push_back(name_for(version));
  return names;
}

std::optional<shaders::VulkanVersion> spirv_target(std::string_view target) {
  if (target == "spirv") return shaders::VulkanVersion::v1_1;
  for (const shaders::VulkanVersion version : shaders::all_vulkan_versions)
    if (target == name_for(version)) return version;
  return std::nullopt;
}

std::vector<std::pair<shaders::VulkanVersion, std::vector<std::string>>> by_vulkan_version(
    const std::vector<std::string>& targets) {
  std::vector<std::pair<shaders::VulkanVersion, std::vector<std::string>>> groups;
  for (const shaders::VulkanVersion version : shaders::all_vulkan_versions) {
    std::vector<std::string> of_version;
    for (const std::string& target : targets)
      if (target != fxc_target && spirv_target(target).value_or(shaders::VulkanVersion::v1_1) == version)
        of_version.push_back(target);
    if (!of_version.empty()) groups.emplace_back(version, std::move(of_version));
  }
  if (std::find(targets.begin(), targets.end(), fxc_target) != targets.end())
    groups.emplace_back(shaders::VulkanVersion::v1_1, std::vector<std::string>{std::string(fxc_target)});
  return groups;
}

}  // namespace penumbra::validation
