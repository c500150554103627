// Runs a pure function of ShaderLibrary on the GPU over many inputs at once.
//
//   CoreFunction gap{"DepthConvention", "Out(0, DepthGap(In(0), In(1)));", 2, 1};
//   std::vector<float> results = run(gap, DepthDirection::reversed, inputs);
//
// Inputs and outputs travel as 32-bit words, so NaN payloads and infinities arrive as they are.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gpu/device.h"
#include "shaders/compile.h"

namespace penumbra::shader_library_tests {

enum class DepthDirection { conventional, reversed };

constexpr DepthDirection kDepthDirections[] = {DepthDirection::conventional, DepthDirection::reversed};

struct CoreFunction {
  std::string file;       // name in `folder`, without its ending
  std::string statement;  // HLSL of kernel_text()
  int inputs = 1;         // words per case
  int outputs = 1;
  std::vector<std::pair<std::string, std::string>> defines = {};
  std::string folder = "Core";  // folder in ShaderLibrary/
  // Every operation of floats has 16 bits instead of 32; arguments are rounded to them.
  bool half = false;
};

inline CoreFunction function_in(std::string folder, std::string file, std::string statement, int inputs,
                                int outputs) {
  return {std::move(file), std::move(statement), inputs, outputs, {}, std::move(folder)};
}

constexpr std::uint32_t kGroupSize = 64;

// The device of all of this folder's kernels.
gpu::Device& device();

// A kernel that runs the statement for each case: In(i) to In4(i), InMatrix(i) and InInt(i) read its words
// from the i-th on, Out(i, value) to Out4(i, value) and OutInt(i, value) write them.
std::string kernel_text(const std::string& includes, const std::string& statement, int inputs, int outputs);
std::vector<std::uint32_t> compiled(const shaders::CompileRequest& request);

// Whether the device has 16-bit arithmetic; `run` throws for `half` without it.
bool has_half_arithmetic();
std::string device_name();

// Runs one case after the other in `inputs`, and returns results in the same order, from the software device
// when there is one.
std::vector<float> run(const CoreFunction& function, DepthDirection direction,
                       const std::vector<float>& inputs);
// For functions that read no depth as it is stored.
inline std::vector<float> run(const CoreFunction& function, const std::vector<float>& inputs) {
  return run(function, DepthDirection::conventional, inputs);
}

}  // namespace penumbra::shader_library_tests
