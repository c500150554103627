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
  request.text = kernel_text("#include \"Platform/Platform.hlsl\"\n#include \"" + function.folder + "/" +
                                 function.file + ".hlsl\"\n",
                             function.statement, function.inputs, function.outputs);
  request.defines = function.defines;
  if (direction == DepthDirection::reversed) request.defines.emplace_back("UNITY_REVERSED_Z", "1");
  request.include_directories = {std::string(PENUMBRA_SOURCE_DIR) + "/ShaderLibrary"};
  std::vector<std::uint32_t> spirv = compiled(request);
  return function.half ? in_half(spirv) : spirv;
}

}  // namespace

gpu::Device& device() {
  static gpu::Device shared({.name = "", .validation = true});
  return shared;
}

std::string kernel_text(const std::string& includes, const std::string& statement, int inputs, int outputs) {
  return includes + "#define INPUTS " + std::to_string(inputs) + "u\n#define OUTPUTS " +
         std::to_string(outputs) + "u\n#define GROUP " + std::to_string(kGroupSize) + R"(
StructuredBuffer<uint> inputs;
RWStructuredBuffer<uint> outputs;
static uint caseIndex;
float In(uint i) { return asfloat(inputs[caseIndex * INPUTS + i]); }
int InInt(uint i) { return int(In(i)); }
float2 In2(uint i) { return float2(In(i), In(i + 1)); }
float3 In3(uint i) { return float3(In2(i), In(i + 2)); }
float4 In4(uint i) { return float4(In2(i), In2(i + 2)); }
float4x4 InMatrix(uint i) { return float4x4(In4(i), In4(i + 4), In4(i + 8), In4(i + 12)); }
void Out(uint i, float value) { outputs[caseIndex * OUTPUTS + i] = asuint(value); }
void OutInt(uint i, int value) { Out(i, float(value)); }
void Out2(uint i, float2 value) { Out(i, value.x); Out(i + 1, value.y); }
void Out3(uint i, float3 value) { Out2(i, value.xy); Out(i + 2, value.z); }
void Out4(uint i, float4 value) { Out2(i, value.xy); Out2(i + 2, value.zw); }
[numthreads(GROUP, 1, 1)]
void Main(uint3 id : SV_DispatchThreadID)
{
    caseIndex = id.y * 65536u + id.x;
    )" + statement +
         "\n}\n";
}

std::vector<std::uint32_t> compiled(const shaders::CompileRequest& request) {
  shaders::CompileResult result = shaders::compile(request);
  if (!hlsl::has_errors(result.diagnostics)) return std::move(result.spirv);
  std::string messages;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) messages += format(diagnostic) + "\n";
  throw std::runtime_error(messages);
}

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
