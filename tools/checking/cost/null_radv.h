// Figures of a shader from Mesa's AMD Vulkan driver, RADV, compiled offline for a GPU that is not present.
//
// With RADV_FORCE_FAMILY set, RADV offers a device without hardware, whose pipelines are compiled by its real
// compiler (ACO). Each call runs a separate process, because the variable applies to a whole process. If a
// driver crashes, hangs or is killed, one result is lost; the shaders after it are measured in a new process.
// Variables that change RADV's code generation are cleared there, so the figures depend only on shader,
// family and Mesa version.
//
// Based on Mesa's documentation, "Environment Variables", RADV_FORCE_FAMILY;
// VK_KHR_pipeline_executable_properties.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "cost/figures.h"
#include "hlsl/stage.h"

namespace penumbra::cost {

struct NullRadv {
  std::string family;            // value of RADV_FORCE_FAMILY, for example navi21
  std::filesystem::path worker;  // the program whose "cost-worker" runs run_radv_worker(): penumbra itself
  std::chrono::milliseconds time_limit{60'000};  // limit for one shader
};

struct RadvFamily {
  std::string name;    // the requested name
  std::string device;  // the driver's name of the device
  std::string driver;  // driver and version, for example "radv Mesa 22.3.6"
};

// Throws InputError suggesting the nearest family if the driver does not know the name, EnvironmentError if
// there is no RADV.
RadvFamily open_family(const NullRadv& radv);

struct ModuleToMeasure {
  std::vector<std::uint32_t> spirv;
  hlsl::Stage stage = hlsl::Stage::fragment;  // vertex, fragment or compute
  std::string entry = "Main";
};

struct Measurement {
  std::string failure;                      // why there are no figures; else empty
  std::uint32_t subgroup_size = 0;          // lanes the driver chose
  std::vector<DriverStatistic> statistics;  // all of the driver's, in its order
  Figures figures;
};

// Returns one measurement for each module, in order. Does not throw for an invalid shader or a driver's
// crash: the result is then a failure with its reason. Throws EnvironmentError if the worker cannot be
// started, platform::Interrupted.
std::vector<Measurement> measure(const NullRadv& radv, std::span<const ModuleToMeasure> modules);

// This is the worker's side, which processes shaders one after the other. It identifies this process's RADV
// device, has it compile each SPIR-V module of `input`, and writes the results to `output`, a line of JSON
// for each as soon as it is known. Does not throw for errors of shader or driver: the responses contain them.
// SIGXCPU ends the process after `seconds` of CPU time for one module.
void run_radv_worker(unsigned seconds, std::istream& input, std::ostream& output);

}  // namespace penumbra::cost
