// A headless Vulkan 1.1 device: its choice, its abilities, and the messages of its validation layers.
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

// The lanes that run together and their operations on one another's values, in compute shaders.
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
  std::string name;         // the driver's name of the device, for example "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string driver;       // name and version
  std::string api_version;  // "1.3.230"
  bool is_software = false;      // runs on the CPU: times are CPU times and rank nothing
  bool has_timestamps = false;   // if false, dispatches are timed on the host, submission and wait included
  bool half_arithmetic = false;  // min16float is 16 bits where shaders are compiled so
  bool half_storage = false;     // also in buffers
  SubgroupInfo subgroup;
};

struct DeviceOptions {
  // If empty, it is the software device when there is one, so that the same command gives the same figures on
  // every machine, else the first device. A number is an index of list_devices(). Anything else chooses the
  // first device whose name contains it, upper and lower case alike.
  std::string name;
  bool validation = false;         // loads VK_LAYER_KHRONOS_validation and collects its messages
  double timeout_seconds = 600.0;  // limit of one submission, in which software devices compile, too
};

// Returns all devices with Vulkan 1.1 and a queue for graphics and compute. Throws EnvironmentError when
// there is no Vulkan at all.
std::vector<DeviceInfo> list_devices();

// The warnings and errors of the validation layers. The log outlives its device, to hold the messages of its
// destruction, too.
class ValidationLog {
 public:
  virtual ~ValidationLog() = default;
  virtual std::vector<std::string> messages() const = 0;
};

struct DeviceState;  // defined in device_state.h

class Device {
 public:
  // Throws EnvironmentError naming the available devices when none fits, or naming what is missing.
  explicit Device(const DeviceOptions& options = {});
  ~Device();
  Device(Device&&) noexcept;
  Device& operator=(Device&&) noexcept;

  const DeviceInfo& info() const;
  // Returns whether images of this format can be made here; 24-bit depth is optional in Vulkan.
  bool supports(Format format) const;
  FormatUses uses(Format format) const;
  std::shared_ptr<const ValidationLog> validation_log() const;  // the log is empty without validation

  const std::shared_ptr<DeviceState>& state() const { return state_; }

 private:
  std::shared_ptr<DeviceState> state_;
};

}  // namespace penumbra::gpu
