// The statistics that a driver's compiler reports about its code for a shader: instructions, registers,
// occupancy.
//
// Based on VK_KHR_pipeline_executable_properties: names, meanings and number of the figures are the driver's
// own. Pipelines are made and queried, never run: no queue, memory or command buffer is touched, so a device
// without hardware behind it (RADV with RADV_FORCE_FAMILY) serves as well. Descriptors, vertex attributes and
// attachments follow from the modules: 32-bit attributes of as many components as the shader reads, 16-bit
// float colours (32-bit integers where the shader writes integers), one sample, no blending, a depth buffer.
#pragma once

#include <cstdint>

#include "gpu/device.h"

namespace penumbra::gpu {

struct PipelineStatistic {
  std::string name;
  std::string description;
  std::uint64_t value = 0;  // a driver's fractions are rounded
};

// A program of a pipeline; drivers may merge stages or add programs of their own.
struct PipelineExecutable {
  std::string name;
  bool vertex = false;  // the stages it comes from
  bool fragment = false;
  bool compute = false;
  std::uint32_t subgroup_size = 0;  // lanes
  std::vector<PipelineStatistic> statistics;
};

struct ShaderEntry {
  std::vector<std::uint32_t> spirv;
  std::string entry = "Main";
};

class StatisticsDevice {
 public:
  // `name` has the meaning of DeviceOptions::name. Throws EnvironmentError when there is no such device, or
  // when it has no VK_KHR_pipeline_executable_properties.
  explicit StatisticsDevice(const std::string& name);
  ~StatisticsDevice();
  StatisticsDevice(StatisticsDevice&&) noexcept;
  StatisticsDevice& operator=(StatisticsDevice&&) noexcept;

  const DeviceInfo& info() const;

  // These throw std::invalid_argument for what pipeline_interface() refuses, and EnvironmentError when the
  // driver makes no pipeline of the modules. Modules must be valid: a driver may crash on others.
  std::vector<PipelineExecutable> compute(const ShaderEntry& shader) const;
  std::vector<PipelineExecutable> graphics(const ShaderEntry& vertex, const ShaderEntry& fragment) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace penumbra::gpu
