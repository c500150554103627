#include "gpu/resources.h"

#include <cstring>
#include <stdexcept>

#include "gpu/resource_state.h"

namespace penumbra::gpu {
namespace {

constexpr std::uint32_t depth24_mask = 0x00FF'FFFFU;

vk::BufferImageCopy whole(const ImageState& image) {
  return {0, 0, 0, {image.texel.copied, 0, 0, 1}, {}, vk::Extent3D(image.extent, 1)};
}

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

vk::raii::ImageView view_of(const ImageState& state, vk::ImageAspectFlags aspects) {
  return {state.device->device, vk::ImageViewCreateInfo({}, *state.image, vk::ImageViewType::e2D,
                                                        state.texel.format, {}, {aspects, 0, 1, 0, 1})};
}

void make_image(ImageState& state) {
  DeviceState& device = *state.device;
  state.image = vk::raii::Image(
      device.device,
      vk::ImageCreateInfo({}, vk::ImageType::e2D, state.texel.format, vk::Extent3D(state.extent, 1), 1, 1,
                          vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal, state.texel.usage));
  state.memory =
      device.allocate(state.image.getMemoryRequirements(), vk::MemoryPropertyFlagBits::eDeviceLocal);
  state.image.bindMemory(*state.memory, 0);
  state.shader_view = view_of(state, state.texel.copied);
  state.target_view = view_of(state, state.texel.aspects);
}

vk::SamplerCreateInfo describe(SamplerKind kind) {
  const bool repeat = kind == SamplerKind::point_repeat || kind == SamplerKind::linear_repeat;
  const bool point = kind == SamplerKind::point_clamp || kind == SamplerKind::point_repeat;
  vk::SamplerCreateInfo info;
  info.addressModeU = info.addressModeV = info.addressModeW =
      repeat ? vk::SamplerAddressMode::eRepeat : vk::SamplerAddressMode::eClampToEdge;
  info.mipmapMode = vk::SamplerMipmapMode::eNearest;
  info.magFilter = info.minFilter = point ? vk::Filter::eNearest : vk::Filter::eLinear;
  info.compareEnable = kind == SamplerKind::compare_less_equal || kind == SamplerKind::compare_greater_equal;
  info.compareOp = kind == SamplerKind::compare_greater_equal ? vk::CompareOp::eGreaterOrEqual
                                                              : vk::CompareOp::eLessOrEqual;
  return info;
}

}  // namespace

void ImageState::move_to(vk::ImageLayout wanted, const vk::raii::CommandBuffer& commands) {
  if (layout == wanted) return;
  const vk::AccessFlags every = vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite;
  const vk::ImageMemoryBarrier barrier(every, every, layout, wanted, VK_QUEUE_FAMILY_IGNORED,
                                       VK_QUEUE_FAMILY_IGNORED, *image, {texel.aspects, 0, 1, 0, 1});
  commands.pipelineBarrier(vk::PipelineStageFlagBits::eAllCommands, vk::PipelineStageFlagBits::eAllCommands,
                           {}, nullptr, nullptr, barrier);
  layout = wanted;
}

Buffer::Buffer(const Device& device, std::size_t bytes) : state_(std::make_shared<BufferState>()) {
  if (bytes == 0) throw std::invalid_argument("a buffer of 0 bytes");
  state_->device = device.state();
  if (bytes > state_->device->limits.maxStorageBufferRange) {
    throw EnvironmentError(device.info().name + ": a buffer of " + std::to_string(bytes) +
                           " bytes is too large; the most is " +
                           std::to_string(state_->device->limits.maxStorageBufferRange));
  }
  guarded(*state_->device, "make a buffer", [this, bytes] {
    state_->allocation = state_->device->make_buffer(bytes,
                                                     vk::BufferUsageFlagBits::eStorageBuffer |
                                                         vk::BufferUsageFlagBits::eTransferSrc |
                                                         vk::BufferUsageFlagBits::eTransferDst,
                                                     vk::MemoryPropertyFlagBits::eDeviceLocal);
  });
}

std::size_t Buffer::size_bytes() const {
  return state_->allocation.bytes;
}

void Buffer::upload_bytes(std::span<const std::byte> bytes) {
  if (bytes.size() > size_bytes()) throw std::invalid_argument("upload is larger than its buffer");
  if (bytes.empty()) return;
  DeviceState& device = *state_->device;
  guarded(device, "upload a buffer", [&] {
    const Allocation& staging = device.staging_of(bytes.size());
    std::memcpy(staging.mapped, bytes.data(), bytes.size());
    device.submit(
        [&](const vk::raii::CommandBuffer& commands) {
          commands.copyBuffer(*staging.buffer, *state_->allocation.buffer,
                              vk::BufferCopy(0, 0, bytes.size()));
        },
        state_);
  });
}

void Buffer::download_bytes(std::span<std::byte> bytes) const {
  if (bytes.size() != size_bytes()) {
    throw std::invalid_argument("a buffer of " + std::to_string(size_bytes()) +
                                " bytes is not a whole number of the elements asked for");
  }
  DeviceState& device = *state_->device;
  guarded(device, "download a buffer", [&] {
    const Allocation& staging = device.staging_of(bytes.size());
    device.submit(
        [&](const vk::raii::CommandBuffer& commands) {
          commands.copyBuffer(*state_->allocation.buffer, *staging.buffer,
                              vk::BufferCopy(0, 0, bytes.size()));
        },
        state_);
    std::memcpy(bytes.data(), staging.mapped, bytes.size());
  });
}

Image::Image(const Device& device, Format format, int width, int height)
    : state_(std::make_shared<ImageState>()) {
  state_->device = device.state();
  state_->format = format;
  if (width <= 0 || height <= 0) throw std::invalid_argument("an image without texels");
  const std::optional<TexelFormat> texel = texel_format_of(*state_->device, format);
  if (!texel) throw EnvironmentError(device.info().name + ": no " + gpu::name(format) + " images here");
  const int most = static_cast<int>(state_->device->limits.maxImageDimension2D);
  if (width > most || height > most) {
    throw EnvironmentError(device.info().name + ": an image of " + std::to_string(width) + " x " +
                           std::to_string(height) + " is too large; the most is " + std::to_string(most));
  }
  state_->texel = *texel;
  state_->extent = vk::Extent2D(std::uint32_t(width), std::uint32_t(height));
  guarded(*state_->device, "make an image", [this] { make_image(*state_); });
}

Format Image::format() const {
  return state_->format;
}
int Image::width() const {
  return static_cast<int>(state_->extent.width);
}
int Image::height() const {
  return static_cast<int>(state_->extent.height);
}

void Image::upload_bytes(std::span<const std::byte> bytes) {
  if (bytes.size() != size_bytes()) {
    throw std::invalid_argument("an image of " + std::to_string(size_bytes()) + " bytes got " +
                                std::to_string(bytes.size()));
  }
  DeviceState& device = *state_->device;
  guarded(device, "upload an image", [&] {
    const Allocation& staging = device.staging_of(bytes.size());
    std::memcpy(staging.mapped, bytes.data(), bytes.size());
    device.submit(
        [&](const vk::raii::CommandBuffer& commands) {
          state_->move_to(vk::ImageLayout::eTransferDstOptimal, commands);
          commands.copyBufferToImage(*staging.buffer, *state_->image, state_->layout, whole(*state_));
        },
        state_);
  });
}

void Image::download_bytes(std::span<std::byte> bytes) const {
  if (bytes.size() != size_bytes()) {
    throw std::invalid_argument("an image of " + std::to_string(size_bytes()) +
                                " bytes is not a whole number of the elements asked for");
  }
  DeviceState& device = *state_->device;
  guarded(device, "download an image", [&] {
    const Allocation& staging = device.staging_of(bytes.size());
    device.submit(
        [&](const vk::raii::CommandBuffer& commands) {
          state_->move_to(vk::ImageLayout::eTransferSrcOptimal, commands);
          commands.copyImageToBuffer(*state_->image, state_->layout, *staging.buffer, whole(*state_));
        },
        state_);
    std::memcpy(bytes.data(), staging.mapped, bytes.size());
  });
  clear_undefined_bits(state_->format, bytes);
}

Sampler::Sampler(const Device& device, SamplerKind kind) : state_(std::make_shared<SamplerState>()) {
  state_->device = device.state();
  guarded(*state_->device, "make a sampler",
          [this, kind] { state_->sampler = vk::raii::Sampler(state_->device->device, describe(kind)); });
}

}  // namespace penumbra::gpu
