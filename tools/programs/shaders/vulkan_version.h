// The versions of Vulkan that a module can be compiled and validated for.
//
// Source: the Vulkan specification, appendix "Vulkan Environment for SPIR-V": 1.0 accepts SPIR-V 1.0, 1.1 up
// to 1.3, 1.2 up to 1.5. Modules for 1.2 are SPIR-V 1.3, which it accepts, too.
#pragma once

namespace penumbra::shaders {

enum class VulkanVersion { v1_0, v1_1, v1_2 };

inline constexpr VulkanVersion all_vulkan_versions[] = {VulkanVersion::v1_0, VulkanVersion::v1_1,
                                                        VulkanVersion::v1_2};

const char* vulkan_version_name(VulkanVersion version);  // "1.0"

}  // namespace penumbra::shaders
