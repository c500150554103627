#include "gpu/texel_format.h"

namespace penumbra::gpu {
namespace {

constexpr vk::ImageUsageFlags every_image = vk::ImageUsageFlagBits::eSampled |
                                            vk::ImageUsageFlagBits::eTransferSrc |
                                            vk::ImageUsageFlagBits::eTransferDst;

TexelFormat depth_format(vk::Format format, vk::ImageAspectFlags aspects = vk::ImageAspectFlagBits::eDepth) {
  return {format, aspects, vk::ImageAspectFlagBits::eDepth,
          every_image | vk::ImageUsageFlagBits::eDepthStencilAttachment};
}

TexelFormat colour_format(vk::Format format) {
  return {format, vk::ImageAspectFlagBits::eColor, vk::ImageAspectFlagBits::eColor,
          every_image | vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eColorAttachment};
}

std::vector<TexelFormat> forms_of(Format format) {
  switch (format) {
    case Format::depth16:
      return {depth_format(vk::Format::eD16Unorm)};
    case Format::depth24:
      return {depth_format(vk::Format::eX8D24UnormPack32),
              depth_format(vk::Format::eD24UnormS8Uint,
                           vk::ImageAspectFlagBits::eDepth | vk::ImageAspectFlagBits::eStencil)};
    case Format::depth32:
      return {depth_format(vk::Format::eD32Sfloat)};
    case Format::r32f:
      return {colour_format(vk::Format::eR32Sfloat)};
    case Format::rg32f:
      return {colour_format(vk::Format::eR32G32Sfloat)};
    case Format::rgba32f:
      return {colour_format(vk::Format::eR32G32B32A32Sfloat)};
  }
  return {};
}

bool has(const DeviceState& device, const TexelFormat& form) {
  // Not through Vulkan-Hpp's throwing call: "not supported" is an answer here.
  VkImageFormatProperties properties;
  return device.physical.getDispatcher()->vkGetPhysicalDeviceImageFormatProperties(
             *device.physical, VkFormat(form.format), VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL,
             VkImageUsageFlags(form.usage), 0, &properties) == VK_SUCCESS;
}

}  // namespace

bool is_depth(Format format) {
  return format == Format::depth16 || format == Format::depth24 || format == Format::depth32;
}

std::size_t texel_bytes(Format format) {
  switch (format) {
    case Format::depth16:
      return 2;
    case Format::depth24:
    case Format::depth32:
    case Format::r32f:
      return 4;
    case Format::rg32f:
      return 8;
    case Format::rgba32f:
      return 16;
  }
  return 0;
}

const char* name(Format format) {
  switch (format) {
    case Format::depth16:
      return "depth16";
    case Format::depth24:
      return "depth24";
    case Format::depth32:
      return "depth32";
    case Format::r32f:
      return "r32f";
    case Format::rg32f:
      return "rg32f";
    case Format::rgba32f:
      return "rgba32f";
  }
  return "";
}

std::optional<TexelFormat> texel_format_of(const DeviceState& device, Format format) {
  for (const TexelFormat& form : forms_of(format)) {
    if (has(device, form)) return form;
  }
  return std::nullopt;
}

}  // namespace penumbra::gpu
