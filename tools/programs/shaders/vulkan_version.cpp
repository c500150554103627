#include "shaders/vulkan_version.h"

namespace penumbra::shaders {

const char* vulkan_version_name(VulkanVersion version) {
  switch (version) {
    case VulkanVersion::v1_0:
      return "1.0";
    case VulkanVersion::v1_1:
      break;
    case VulkanVersion::v1_2:
      return "1.2";
  }
  return "1.1";
}

}  // namespace penumbra::shaders
