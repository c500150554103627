#include <cstring>
#include <stdexcept>

#include "gpu/resource_state.h"

namespace penumbra::gpu {

Buffer::Buffer(const Device& device, std::size_t bytes) : state_(std::make_shared<BufferState>()) {
  if (bytes == 0) throw std::invalid_argument("a buffer of 0 bytes");
  state_->device = device.state();
  if (bytes > state_->device->limits.maxStorageBufferRange)
    throw EnvironmentError(device.info().name + ": a buffer of " + std::to_string(bytes) +
                           " bytes is too large; the most is " +
                           std::to_string(state_->device->limits.maxStorageBufferRange));
  guarded(*state_->device, "make a buffer", [this, bytes] {
    state_->allocation = state_->device->make_buffer(
        bytes,
        vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eVertexBuffer |
            vk::BufferUsageFlagBits::eIndexBuffer | vk::BufferUsageFlagBits::eTransferSrc |
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
  if (bytes.size() != size_bytes())
    throw std::invalid_argument("a buffer of " + std::to_string(size_bytes()) +
                                " bytes is not a whole number of the elements asked for");
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

}  // namespace penumbra::gpu
