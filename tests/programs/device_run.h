// Runs programs on the device, through a compiler as any shader goes: preparation and glslang, or FXC and its
// bytecode.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "programs/program.h"

namespace penumbra::programs {

struct DeviceRun {
  std::string error;                 // error of the compiler or the device; empty for none
  std::string refusal;               // FXC's error; empty for none
  std::vector<std::uint32_t> words;  // kOutputs for each program, for each set of inputs, sets first
};

enum class Compiler { glslang, fxc };

// `inputs` has kInputs words for each of the sets.
DeviceRun run_on_device(const std::vector<const Program*>& programs, const std::vector<std::uint32_t>& inputs,
                        Compiler compiler);

std::string device_name();  // the name with that of its driver

}  // namespace penumbra::programs
