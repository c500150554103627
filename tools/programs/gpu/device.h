// A headless Vulkan 1.1 device: which one, what it can do, what its validation layers said.
//
// Guarantees: every submission is waited for with a timeout, so a shader that never ends is an
// EnvironmentError and not a hang; objects made from a device may outlive it. One thread at a time may use a
// device and what was made from it. No Vulkan type appears in this folder's headers.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gpu/format.h"

namespace penumbra::gpu {

// Lanes that run together and what they can do with one another's values, in compute shaders.
struct SubgroupInfo {
  int lanes = 1;
  bool vote = false;        // WaveActiveAnyTrue, ...
  bool arithmetic = false;  // WaveActiveSum, WavePrefixSum, ...
  bool ballot = false;      // WaveActiveBallot, WaveReadLaneFirst, ...
  bool shuffle = false;     // WaveReadLaneAt
  bool quad = false;        // QuadReadAcrossX, ...
};

struct DeviceInfo {
  int index = 0;
  std::string name;              // as the driver gives it, for example "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string driver;            // name and version
  std::string api_version;       // "1.3.230"
  bool is_software = false;      // runs on the CPU: times are CPU times and rank nothing
  bool has_timestamps = false;   // else dispatches are timed on the host, submission and wait included
  bool half_arithmetic = false;  // min16float is 16 bits where shaders are compiled so
  bool half_storage = false;     // in buffers too
  SubgroupInfo subgroup;
};

struct DeviceOptions {
  // Empty: the software device when there is one, so that the same command gives the same figures on every
  // machine, else the first device. A number: that index of list_devices(). Anything else: the first device
  // whose name contains it, upper and lower case alike.
  std::string name;
  bool validation = false;         // load VK_LAYER_KHRONOS_validation and collect what it says
  double timeout_seconds = 600.0;  // of one submission, in which software devices compile, too
};

// All devices with Vulkan 1.1 and a queue for graphics and compute. Throws EnvironmentError when there is no
// Vulkan at all.
std::vector<DeviceInfo> list_devices();

// Warnings and errors of the validation layers. Lives on after its device, to hold what teardown said too.
class ValidationLog {
 public:
  virtual ~ValidationLog() = default;
  virtual std::vector<std::string> messages() const = 0;
};

struct DeviceState;  // defined in device_state.h

class Device {
 public:
  // Throws EnvironmentError naming the devices there are when none fits, or saying what is missing.
  explicit Device(const DeviceOptions& options = {});
  ~Device();
  Device(Device&&) noexcept;
  Device& operator=(Device&&) noexcept;

  const DeviceInfo& info() const;
  // Whether images of this format can be made here; 24-bit depth is optional in Vulkan.
  bool supports(Format format) const;
  FormatUses uses(Format format) const;
  std::shared_ptr<const ValidationLog> validation_log() const;  // empty log without validation

  const std::shared_ptr<DeviceState>& state() const { return state_; }

 private:
  std::shared_ptr<DeviceState> state_;
};

}  // namespace penumbra::gpu
