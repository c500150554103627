#include "gpu/device_state.h"

#include <algorithm>
#include <chrono>

namespace penumbra::gpu {
namespace {

constexpr std::uint64_t last_wait_nanoseconds = 10'000'000'000;

void full_barrier(const vk::raii::CommandBuffer& commands, vk::PipelineStageFlags from,
                  vk::PipelineStageFlags to) {
  const vk::MemoryBarrier barrier(
      vk::AccessFlagBits::eMemoryWrite | vk::AccessFlagBits::eHostWrite,
      vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite | vk::AccessFlagBits::eHostRead);
  commands.pipelineBarrier(from, to, {}, barrier, nullptr, nullptr);
}

}  // namespace

std::vector<std::string> MessageLog::messages() const {
  const std::lock_guard lock(mutex_);
  return messages_;
}

void MessageLog::add(const char* message) {
  const std::lock_guard lock(mutex_);
  messages_.emplace_back(message);
}

void DeviceState::make_timestamps(std::uint32_t steps) {
  if (steps <= timestamp_steps) return;
  timestamps = vk::raii::QueryPool(device, vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, steps + 1));
  timestamp_steps = steps;
}

std::vector<double> DeviceState::submit(const std::function<void(const vk::raii::CommandBuffer&)>& record,
                                        const std::shared_ptr<void>& used, std::uint32_t marked) {
  if (stuck)
    throw EnvironmentError(info.name + ": an earlier submission ran out of time; open the device again");
  using Clock = std::chrono::steady_clock;
  const vk::PipelineStageFlags everything =
      vk::PipelineStageFlagBits::eAllCommands | vk::PipelineStageFlagBits::eHost;
  const bool timed = info.has_timestamps && marked > 0;
  if (timed) make_timestamps(marked);
  commands.reset();
  commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
  if (timed) commands.resetQueryPool(*timestamps, 0, marked + 1);
  full_barrier(commands, everything, vk::PipelineStageFlagBits::eAllCommands);
  record(commands);
  full_barrier(commands, vk::PipelineStageFlagBits::eAllCommands, everything);
  commands.end();

  const Clock::time_point start = Clock::now();
  device.resetFences(*fence);
  queue.submit(vk::SubmitInfo({}, {}, *commands, {}), *fence);
  wait_for_fence(used);
  const std::chrono::duration<double, std::nano> wall = Clock::now() - start;
  if (timed) return times(marked);
  std::vector<double> nanoseconds(marked, 0.0);
  if (marked > 0) nanoseconds.front() = wall.count();
  return nanoseconds;
}

std::vector<double> DeviceState::times(std::uint32_t steps) const {
  const std::size_t count = std::size_t(steps) + 1;
  const auto [result, ticks] = timestamps.getResults<std::uint64_t>(
      0, std::uint32_t(count), count * sizeof(std::uint64_t), sizeof(std::uint64_t),
      vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
  std::vector<double> nanoseconds;
  std::uint64_t ended = 0;  // ticks since the first step's begin when all earlier steps had ended
  for (std::size_t step = 0; step < steps; ++step) {
    const std::uint64_t end = (ticks[step + 1] - ticks.front()) & timestamp_mask;
    nanoseconds.push_back(double(end - std::min(ended, end)) * double(limits.timestampPeriod));
    ended = std::max(ended, end);
  }
  return nanoseconds;
}

void DeviceState::wait_for_fence(const std::shared_ptr<void>& used) {
  const auto nanoseconds = static_cast<std::uint64_t>(timeout_seconds * 1e9);
  if (device.waitForFences(*fence, VK_TRUE, nanoseconds) == vk::Result::eSuccess) return;
  stuck = used;
  throw EnvironmentError(info.name + ": a submission did not finish within " +
                         std::to_string(timeout_seconds) +
                         " s\n  the shader loops for ever, or the device needs a longer timeout");
}

void DeviceState::release_stuck() {
  if (!stuck) return;
  if (device.waitForFences(*fence, VK_TRUE, last_wait_nanoseconds) == vk::Result::eSuccess) stuck.reset();
}

void DeviceState::mark_begin(const vk::raii::CommandBuffer& commands_in_use) const {
  if (!info.has_timestamps) return;
  commands_in_use.writeTimestamp(vk::PipelineStageFlagBits::eTopOfPipe, *timestamps, 0);
}

void DeviceState::mark_end(const vk::raii::CommandBuffer& commands_in_use, std::uint32_t step) const {
  if (!info.has_timestamps) return;
  commands_in_use.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, *timestamps, step + 1);
}

vk::raii::DeviceMemory DeviceState::allocate(const vk::MemoryRequirements& requirements,
                                             vk::MemoryPropertyFlags wanted) const {
  const vk::PhysicalDeviceMemoryProperties memory = physical.getMemoryProperties();
  for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
    const bool allowed = (requirements.memoryTypeBits >> type & 1U) != 0;
    if (!allowed || (memory.memoryTypes[type].propertyFlags & wanted) != wanted) continue;
    return {device, vk::MemoryAllocateInfo(requirements.size, type)};
  }
  throw EnvironmentError(info.name + ": no memory type with " + vk::to_string(wanted));
}

Allocation DeviceState::make_buffer(std::size_t bytes, vk::BufferUsageFlags usage,
                                    vk::MemoryPropertyFlags wanted) const {
  Allocation made;
  made.bytes = bytes;
  made.buffer = vk::raii::Buffer(device, vk::BufferCreateInfo({}, bytes, usage));
  made.memory = allocate(made.buffer.getMemoryRequirements(), wanted);
  made.buffer.bindMemory(*made.memory, 0);
  if (wanted & vk::MemoryPropertyFlagBits::eHostVisible)
    made.mapped = static_cast<std::byte*>(made.memory.mapMemory(0, VK_WHOLE_SIZE));
  return made;
}

Allocation& DeviceState::staging_of(std::size_t bytes) {
  if (staging.bytes < bytes) {
    staging = {};  // frees the old one first
    staging =
        make_buffer(bytes, vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst,
                    vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent);
  }
  return staging;
}

}  // namespace penumbra::gpu
