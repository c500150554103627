#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "gpu/resource_state.h"
#include "gpu/resource_uses.h"

namespace penumbra::gpu {
namespace {

constexpr std::uint32_t depth24_mask = 0x00FF'FFFFU;

// The upper eight bits of a 24-bit depth texel are undefined after a copy.
void clear_undefined_bits(Format format, std::span<std::byte> bytes) {
  if (format != Format::depth24) return;
  for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
    std::uint32_t texel = 0;
    std::memcpy(&texel, &bytes[at], sizeof(texel));
    texel &= depth24_mask;
    std::memcpy(&bytes[at], &texel, sizeof(texel));
  }
}

vk::ImageUsageFlags usage_of(const ImageState& state) {
  if (state.shape.samples == 1) return state.texel.usage;
  // The image can be cleared.
  return vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst |
         (is_depth(state.shape.format) ? vk::ImageUsageFlagBits::eDepthStencilAttachment
                                       : vk::ImageUsageFlagBits::eColorAttachment);
}

vk::ImageCreateInfo description_of(const ImageState& state) {
  const ImageShape& shape = state.shape;
  return {{},
          shape.depth > 1 ? vk::ImageType::e3D : vk::ImageType::e2D,
          state.texel.format,
          state.extent(0),
          std::uint32_t(shape.mips),
          std::uint32_t(shape.layers),
          static_cast<vk::SampleCountFlagBits>(shape.samples),
          vk::ImageTiling::eOptimal,
          usage_of(state)};
}

void check(const ImageShape& shape) {
  if (shape.width <= 0 || shape.height <= 0 || shape.depth <= 0 || shape.layers <= 0 || shape.mips <= 0)
    throw std::invalid_argument("an image without texels");
  if (shape.depth > 1 && shape.layers > 1) throw std::invalid_argument("a 3D image has one layer");
  if (shape.mips > mip_count(shape.width, shape.height, shape.depth))
    throw std::invalid_argument("more mip levels than the image has sizes");
  if (shape.samples != 1 && (shape.depth > 1 || shape.mips > 1))
    throw std::invalid_argument("an image with several samples is 2D and has one mip level");
  if (shape.samples < 1 || (shape.samples & (shape.samples - 1)) != 0)
    throw std::invalid_argument("the number of samples is a power of two");
}

void check_limits(const DeviceState& device, const ImageState& state) {
  const ImageShape& shape = state.shape;
  const std::string refused = device.info.name + ": an image of " + std::to_string(shape.width) + " x " +
                              std::to_string(shape.height) +
                              (shape.depth > 1 ? " x " + std::to_string(shape.depth) : "");
  VkImageFormatProperties most;
  const vk::ImageCreateInfo info = description_of(state);
  if (device.physical.getDispatcher()->vkGetPhysicalDeviceImageFormatProperties(
          *device.physical, VkFormat(info.format), VkImageType(info.imageType), VK_IMAGE_TILING_OPTIMAL,
          VkImageUsageFlags(info.usage), 0, &most) != VK_SUCCESS)
    throw EnvironmentError(device.info.name + ": no " + name(shape.format) + " images of this kind here");
  const vk::Extent3D extent = state.extent(0);
  if (extent.width > most.maxExtent.width || extent.height > most.maxExtent.height ||
      extent.depth > most.maxExtent.depth)
    throw EnvironmentError(refused + " is too large; the most is " + std::to_string(most.maxExtent.width));
  if (std::uint32_t(shape.layers) > most.maxArrayLayers)
    throw EnvironmentError(refused + " has at most " + std::to_string(most.maxArrayLayers) + " layers here");
  if (!(most.sampleCounts & VkSampleCountFlags(shape.samples)))
    throw EnvironmentError(refused + " has no " + std::to_string(shape.samples) + " samples here");
}

void make_image(ImageState& state) {
  DeviceState& device = *state.device;
  state.image = vk::raii::Image(device.device, description_of(state));
  state.memory =
      device.allocate(state.image.getMemoryRequirements(), vk::MemoryPropertyFlagBits::eDeviceLocal);
  state.image.bindMemory(*state.memory, 0);
  state.layouts.assign(
      static_cast<std::size_t>(state.shape.mips) * static_cast<std::size_t>(state.shape.layers),
      vk::ImageLayout::eUndefined);
}

vk::BufferImageCopy copy_of(const ImageState& state, ImagePart part) {
  return {0,  0,
          0,  {state.texel.copied, std::uint32_t(part.mip), std::uint32_t(part.layer), 1},
          {}, state.extent(part.mip)};
}

void check_copy(const ImageState& state, ImagePart part, std::size_t wanted, std::size_t given) {
  if (state.shape.samples > 1)
    throw std::logic_error("an image with several samples is resolved, not copied");
  if (part.mip < 0 || part.mip >= state.shape.mips || part.layer < 0 || part.layer >= state.shape.layers)
    throw std::invalid_argument("a mip level or layer that the image does not have");
  if (wanted != given)
    throw std::invalid_argument("an image of " + std::to_string(wanted) + " bytes and " +
                                std::to_string(given) + " bytes to copy");
}

}  // namespace

int mip_size(int size, int mip) {
  return std::max(1, size >> mip);
}

int mip_count(int width, int height, int depth) {
  int count = 1;
  for (int size = std::max({width, height, depth}); size > 1; size >>= 1) ++count;
  return count;
}

vk::Extent3D ImageState::extent(int mip) const {
  return {std::uint32_t(mip_size(shape.width, mip)), std::uint32_t(mip_size(shape.height, mip)),
          std::uint32_t(mip_size(shape.depth, mip))};
}

vk::ImageLayout& ImageState::layout(int mip, int layer) {
  return layouts.at(static_cast<std::size_t>(mip) * static_cast<std::size_t>(shape.layers) +
                    static_cast<std::size_t>(layer));
}

vk::ImageSubresourceRange ImageState::range(const ImageParts& parts) const {
  return {texel.aspects, std::uint32_t(parts.first_mip), std::uint32_t(parts.mips),
          std::uint32_t(parts.first_layer), std::uint32_t(parts.layers)};
}

vk::ImageView ImageState::view(const ImageParts& parts, vk::ImageViewType type, bool target) {
  const ViewKey key{parts, type, target};
  auto found = views_.find(key);
  if (found == views_.end()) {
    vk::ImageSubresourceRange shown = range(parts);
    if (!target) shown.aspectMask = texel.copied;
    found =
        views_
            .emplace(key, vk::raii::ImageView(device->device, vk::ImageViewCreateInfo(
                                                                  {}, *image, type, texel.format, {}, shown)))
            .first;
  }
  return *found->second;
}

Image::Image(const Device& device, const ImageShape& shape) : state_(std::make_shared<ImageState>()) {
  check(shape);
  state_->device = device.state();
  state_->shape = shape;
  state_->texel = need_texel_format(*state_->device, shape.format);
  check_limits(*state_->device, *state_);
  guarded(*state_->device, "make an image", [this] { make_image(*state_); });
}

const ImageShape& Image::shape() const {
  return state_->shape;
}

std::size_t Image::size_bytes(int mip) const {
  const vk::Extent3D extent = state_->extent(mip);
  return texel_bytes(format()) * extent.width * extent.height * extent.depth;
}

void Image::upload_bytes(std::span<const std::byte> bytes, ImagePart part) {
  check_copy(*state_, part, size_bytes(part.mip), bytes.size());
  DeviceState& device = *state_->device;
  guarded(device, "upload an image", [&] {
    const Allocation& staging = device.staging_of(bytes.size());
    std::memcpy(staging.mapped, bytes.data(), bytes.size());
    device.submit(
        [&](const vk::raii::CommandBuffer& commands) {
          move_to(*state_, {part.mip, 1, part.layer, 1}, vk::ImageLayout::eTransferDstOptimal, commands);
          commands.copyBufferToImage(*staging.buffer, *state_->image, vk::ImageLayout::eTransferDstOptimal,
                                     copy_of(*state_, part));
        },
        state_);
  });
}

void Image::download_bytes(std::span<std::byte> bytes, ImagePart part) const {
  check_copy(*state_, part, size_bytes(part.mip), bytes.size());
  DeviceState& device = *state_->device;
  guarded(device, "download an image", [&] {
    const Allocation& staging = device.staging_of(bytes.size());
    device.submit(
        [&](const vk::raii::CommandBuffer& commands) {
          move_to(*state_, {part.mip, 1, part.layer, 1}, vk::ImageLayout::eTransferSrcOptimal, commands);
          commands.copyImageToBuffer(*state_->image, vk::ImageLayout::eTransferSrcOptimal, *staging.buffer,
                                     copy_of(*state_, part));
        },
        state_);
    std::memcpy(bytes.data(), staging.mapped, bytes.size());
  });
  clear_undefined_bits(state_->shape.format, bytes);
}

}  // namespace penumbra::gpu
