#include "gpu/texel_format.h"

#include <array>

namespace penumbra::gpu {
namespace {

constexpr vk::ImageUsageFlags copied_and_sampled = vk::ImageUsageFlagBits::eSampled |
                                                   vk::ImageUsageFlagBits::eTransferSrc |
                                                   vk::ImageUsageFlagBits::eTransferDst;

struct Traits {
  Format format;
  const char* name;
  std::size_t bytes;
  bool integer;
  vk::Format form;
};

constexpr std::array<Traits, 22> traits{
    {{Format::depth16, "depth16", 2, false, vk::Format::eD16Unorm},
     {Format::depth24, "depth24", 4, false, vk::Format::eX8D24UnormPack32},
     {Format::depth32, "depth32", 4, false, vk::Format::eD32Sfloat},
     {Format::depth32s8, "depth32s8", 4, false, vk::Format::eD32SfloatS8Uint},
     {Format::r8, "r8", 1, false, vk::Format::eR8Unorm},
     {Format::rg8, "rg8", 2, false, vk::Format::eR8G8Unorm},
     {Format::rgba8, "rgba8", 4, false, vk::Format::eR8G8B8A8Unorm},
     {Format::r16, "r16", 2, false, vk::Format::eR16Unorm},
     {Format::rg16, "rg16", 4, false, vk::Format::eR16G16Unorm},
     {Format::rgba16, "rgba16", 8, false, vk::Format::eR16G16B16A16Unorm},
     {Format::r16f, "r16f", 2, false, vk::Format::eR16Sfloat},
     {Format::rg16f, "rg16f", 4, false, vk::Format::eR16G16Sfloat},
     {Format::rgba16f, "rgba16f", 8, false, vk::Format::eR16G16B16A16Sfloat},
     {Format::r32f, "r32f", 4, false, vk::Format::eR32Sfloat},
     {Format::rg32f, "rg32f", 8, false, vk::Format::eR32G32Sfloat},
     {Format::rgba32f, "rgba32f", 16, false, vk::Format::eR32G32B32A32Sfloat},
     {Format::r11g11b10f, "r11g11b10f", 4, false, vk::Format::eB10G11R11UfloatPack32},
     {Format::r8ui, "r8ui", 1, true, vk::Format::eR8Uint},
     {Format::r16ui, "r16ui", 2, true, vk::Format::eR16Uint},
     {Format::r32ui, "r32ui", 4, true, vk::Format::eR32Uint},
     {Format::rg32ui, "rg32ui", 8, true, vk::Format::eR32G32Uint},
     {Format::rgba32ui, "rgba32ui", 16, true, vk::Format::eR32G32B32A32Uint}}};

const Traits& of(Format format) {
  return traits.at(static_cast<std::size_t>(format));
}

vk::FormatFeatureFlags features(const DeviceState& device, vk::Format form) {
  return device.physical.getFormatProperties(form).optimalTilingFeatures;
}

bool has_images(const DeviceState& device, vk::Format form, vk::ImageUsageFlags usage) {
  // Vulkan-Hpp's call would throw for "not supported", which is an answer here.
  VkImageFormatProperties properties;
  return device.physical.getDispatcher()->vkGetPhysicalDeviceImageFormatProperties(
             *device.physical, VkFormat(form), VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL,
             VkImageUsageFlags(usage), 0, &properties) == VK_SUCCESS;
}

std::optional<TexelFormat> depth_format(const DeviceState& device, vk::Format form,
                                        vk::ImageAspectFlags aspects = vk::ImageAspectFlagBits::eDepth) {
  const vk::ImageUsageFlags usage = copied_and_sampled | vk::ImageUsageFlagBits::eDepthStencilAttachment;
  if (!has_images(device, form, usage)) return std::nullopt;
  return TexelFormat{form, aspects, vk::ImageAspectFlagBits::eDepth, usage};
}

std::optional<TexelFormat> colour_format(const DeviceState& device, vk::Format form) {
  using Feature = vk::FormatFeatureFlagBits;
  const vk::FormatFeatureFlags has = features(device, form);
  vk::ImageUsageFlags usage = copied_and_sampled;
  if (has & Feature::eStorageImage) usage |= vk::ImageUsageFlagBits::eStorage;
  if (has & Feature::eColorAttachment) usage |= vk::ImageUsageFlagBits::eColorAttachment;
  if (!has_images(device, form, usage)) return std::nullopt;
  return TexelFormat{form, vk::ImageAspectFlagBits::eColor, vk::ImageAspectFlagBits::eColor, usage};
}

}  // namespace

std::span<const Format> all_formats() {
  static const auto formats = [] {
    std::array<Format, traits.size()> all{};
    for (std::size_t at = 0; at < traits.size(); ++at) all[at] = traits[at].format;
    return all;
  }();
  return formats;
}

bool is_depth(Format format) {
  return format == Format::depth16 || format == Format::depth24 || format == Format::depth32 ||
         has_stencil(format);
}

bool has_stencil(Format format) {
  return format == Format::depth32s8;
}

bool is_integer(Format format) {
  return of(format).integer;
}

std::size_t texel_bytes(Format format) {
  return of(format).bytes;
}

const char* name(Format format) {
  return of(format).name;
}

std::optional<Format> find_format(std::string_view name) {
  for (const Traits& one : traits)
    if (one.name == name) return one.format;
  return std::nullopt;
}

std::optional<TexelFormat> texel_format_of(const DeviceState& device, Format format) {
  const vk::Format form = of(format).form;
  if (!is_depth(format)) return colour_format(device, form);
  const vk::ImageAspectFlags both = vk::ImageAspectFlagBits::eDepth | vk::ImageAspectFlagBits::eStencil;
  if (has_stencil(format)) return depth_format(device, form, both);
  const std::optional<TexelFormat> found = depth_format(device, form);
  if (found || format != Format::depth24) return found;
  return depth_format(device, vk::Format::eD24UnormS8Uint, both);
}

TexelFormat need_texel_format(const DeviceState& device, Format format) {
  const std::optional<TexelFormat> texel = texel_format_of(device, format);
  if (!texel) throw EnvironmentError(device.info.name + ": no " + name(format) + " images here");
  return *texel;
}

FormatUses uses_of(const DeviceState& device, Format format) {
  using Feature = vk::FormatFeatureFlagBits;
  FormatUses uses;
  const std::optional<TexelFormat> texel = texel_format_of(device, format);
  if (!texel) return uses;
  const vk::FormatFeatureFlags has = features(device, texel->format);
  uses.sampled = true;
  uses.filtered = bool(has & Feature::eSampledImageFilterLinear);
  uses.storage = bool(texel->usage & vk::ImageUsageFlagBits::eStorage);
  uses.target = bool(texel->usage & (vk::ImageUsageFlagBits::eColorAttachment |
                                     vk::ImageUsageFlagBits::eDepthStencilAttachment));
  uses.blended = bool(has & Feature::eColorAttachmentBlend);
  if (!uses.target) return uses;
  const vk::ImageUsageFlags drawn =
      vk::ImageUsageFlagBits::eSampled | (is_depth(format) ? vk::ImageUsageFlagBits::eDepthStencilAttachment
                                                           : vk::ImageUsageFlagBits::eColorAttachment);
  const auto counts =
      device.physical
          .getImageFormatProperties(texel->format, vk::ImageType::e2D, vk::ImageTiling::eOptimal, drawn)
          .sampleCounts;
  for (const int samples : {2, 4, 8, 16})
    if (counts & static_cast<vk::SampleCountFlagBits>(samples)) uses.most_samples = samples;
  return uses;
}

}  // namespace penumbra::gpu
