// The Vulkan side of a Device, for this folder's sources only: handles, memory, and one function that
// submits.
//
// Every submission starts and ends with a full barrier and is waited for, so passes need no synchronisation
// of their own. Only one dispatch or one pass at a time is measured anyway.
#pragma once

#include <functional>
#include <mutex>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/device.h"
#include "input/input_error.h"

namespace penumbra::gpu {

class MessageLog final : public ValidationLog {
 public:
  std::vector<std::string> messages() const override;
  void add(const char* message);

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> messages_;
};

struct Allocation {
  vk::raii::Buffer buffer = nullptr;
  vk::raii::DeviceMemory memory = nullptr;
  std::size_t bytes = 0;
  std::byte* mapped = nullptr;  // set for host-visible memory
};

// The order of members is the order of creation; destruction runs in reverse.
struct DeviceState {
  explicit DeviceState(vk::raii::Context loaded) : context(std::move(loaded)) {}

  DeviceInfo info;
  double timeout_seconds = 0.0;
  std::shared_ptr<MessageLog> log = std::make_shared<MessageLog>();
  vk::raii::Context context;
  vk::raii::Instance instance = nullptr;
  vk::raii::DebugUtilsMessengerEXT messenger = nullptr;
  vk::raii::PhysicalDevice physical = nullptr;
  vk::PhysicalDeviceLimits limits;
  vk::PhysicalDeviceFeatures features;  // features that are switched on
  vk::raii::Device device = nullptr;
  std::uint32_t queue_family = 0;
  vk::raii::Queue queue = nullptr;
  vk::raii::CommandPool command_pool = nullptr;
  vk::raii::CommandBuffer commands = nullptr;
  vk::raii::Fence fence = nullptr;
  std::uint64_t timestamp_mask = 0;          // the significant bits
  vk::raii::QueryPool timestamps = nullptr;  // the first begin, and the end of each marked step; grows
  std::uint32_t timestamp_steps = 0;
  Allocation staging;           // grows to the largest copy so far
  std::shared_ptr<void> stuck;  // resources that a submission which ran out of time may still use

  // Records, submits and waits. `used` is kept alive should the wait time out. Returns the time of each of
  // the `marked` steps in nanoseconds; `record` begins the first of them with mark_begin and ends each with
  // mark_end. A time runs from the end of all steps before it to the step's own end, so that waits count and
  // steps that run at once count once: the sum is the time from the first step's begin to the last one's end.
  // Without timestamps the first has the wall-clock time of the whole submission and the others 0.
  std::vector<double> submit(const std::function<void(const vk::raii::CommandBuffer&)>& record,
                             const std::shared_ptr<void>& used, std::uint32_t marked = 0);
  void mark_begin(const vk::raii::CommandBuffer& commands_in_use) const;
  void mark_end(const vk::raii::CommandBuffer& commands_in_use, std::uint32_t step) const;

  vk::raii::DeviceMemory allocate(const vk::MemoryRequirements& requirements,
                                  vk::MemoryPropertyFlags wanted) const;
  Allocation make_buffer(std::size_t bytes, vk::BufferUsageFlags usage, vk::MemoryPropertyFlags wanted) const;
  Allocation& staging_of(std::size_t bytes);

  // Waits once more for a submission that timed out; when it still runs, its resources are left to the
  // driver for good, because destroying them under a running shader is undefined.
  void release_stuck();

 private:
  void wait_for_fence(const std::shared_ptr<void>& used);
  void make_timestamps(std::uint32_t steps);
  std::vector<double> times(std::uint32_t steps) const;
};

// Runs `action`; a Vulkan failure becomes an EnvironmentError that names the device and the attempt.
template <typename Action>
decltype(auto) guarded(const DeviceState& device, const char* attempt, Action&& action) {
  try {
    return action();
  } catch (const vk::SystemError& error) {
    throw EnvironmentError(device.info.name + ": cannot " + attempt + ": " + error.what());
  }
}

}  // namespace penumbra::gpu
