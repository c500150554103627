#include "ShaderLibrary/core_function.h"

#include <bit>
#include <spirv-tools/optimizer.hpp>
#include <stdexcept>

#include "gpu/compute_pass.h"
#include "gpu/device.h"
#include "gpu/resources.h"
#include "shaders/compile.h"
#include "shaders/reflect.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr std::uint32_t kGroupSize = 64;

gpu::Device& device() {
  static gpu::Device shared({.name = "", .validation = true});
  return shared;
}

std::string source(const CoreFunction& function) {
  return "#include \"Platform/Platform.hlsl\"\n#include \"" + function.folder + "/" + function.file +
         ".hlsl\"\n"
         "StructuredBuffer<uint> inputs;\n"
         "RWStructuredBuffer<uint> outputs;\n"
         "static uint caseIndex;\n"
         "float In(uint i) { return asfloat(inputs[caseIndex * " +
         std::to_string(function.inputs) +
         "u + i]); }\n"
         "int InInt(uint i) { return int(In(i)); }\n"
         "void Out(uint i, float value) { outputs[caseIndex * " +
         std::to_string(function.outputs) +
         "u + i] = asuint(value); }\n"
         "void OutInt(uint i, int value) { Out(i, float(value)); }\n"
         "[numthreads(" +
         std::to_string(kGroupSize) +
         ", 1, 1)]\n"
         "void Main(uint3 id : SV_DispatchThreadID)\n{\n"
         "    caseIndex = id.y * 65536u + id.x;\n    " +
         function.statement + "\n}\n";
}

// Every operation of floats becomes one of 16 bits, its operands rounded, as drivers do with `mediump`.
std::vector<std::uint32_t> in_half(const std::vector<std::uint32_t>& spirv) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
  std::string messages;
  optimizer.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&,
                                   const char* message) { messages += message; });
  optimizer.RegisterPass(spvtools::CreateRelaxFloatOpsPass());
  optimizer.RegisterPass(spvtools::CreateConvertRelaxedToHalfPass());
  std::vector<std::uint32_t> result;
  if (!optimizer.Run(spirv.data(), spirv.size(), &result)) throw std::runtime_error(messages);
  if (result == spirv) throw std::runtime_error("nothing was converted to half");
  return result;
}

std::vector<std::uint32_t> compile(const CoreFunction& function, DepthDirection direction) {
  shaders::CompileRequest request;
  request.file = function.file + " test.hlsl";
  request.text = source(function);
  request.defines = function.defines;
  if (direction == DepthDirection::reversed) request.defines.emplace_back("UNITY_REVERSED_Z", "1");
  request.include_directories = {std::string(PENUMBRA_SOURCE_DIR) + "/ShaderLibrary"};
  shaders::CompileResult result = shaders::compile(request);
  if (!hlsl::has_errors(result.diagnostics))
    return function.half ? in_half(result.spirv) : std::move(result.spirv);
  std::string messages;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) messages += format(diagnostic) + "\n";
  throw std::runtime_error(messages);
}

}  // namespace

bool has_half_arithmetic() {
  return device().info().half_arithmetic;
}

std::string device_name() {
  return device().info().name + ", " + device().info().driver;
}

std::vector<float> run(const CoreFunction& function, DepthDirection direction,
                       const std::vector<float>& inputs) {
  const std::vector<std::uint32_t> spirv = compile(function, direction);

  // The cases fill whole rows of 65536; the last row is padded with zeros.
  const std::size_t cases = inputs.size() / std::size_t(function.inputs);
  const std::size_t columns =
      std::min<std::size_t>(65536, (cases + kGroupSize - 1) / kGroupSize * kGroupSize);
  const std::size_t rows = (cases + columns - 1) / columns;
  std::vector<float> padded = inputs;
  padded.resize(rows * columns * std::size_t(function.inputs), 0.0f);

  const gpu::Buffer input_buffer(device(), std::span<const float>(padded));
  const gpu::Buffer output_buffer(device(), rows * columns * std::size_t(function.outputs) * sizeof(float));
  gpu::ComputePass pass(device(), {.spirv = spirv});
  pass.bindings().buffer("inputs", input_buffer);
  pass.bindings().buffer("outputs", output_buffer);
  pass.dispatch({static_cast<std::uint32_t>(columns) / kGroupSize, static_cast<std::uint32_t>(rows), 1});

  for (const std::string& message : device().validation_log()->messages()) throw std::runtime_error(message);

  std::vector<float> results = output_buffer.download<float>();
  results.resize(cases * std::size_t(function.outputs));
  return results;
}

}  // namespace penumbra::shader_library_tests
