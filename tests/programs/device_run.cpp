#include "programs/device_run.h"

#include <span>

#include "gpu/compute_pass.h"
#include "gpu/device.h"
#include "gpu/resources.h"
#include "programs/program_text.h"
#include "shaders/module_of.h"
#include "shaders/reflect.h"

namespace penumbra::programs {

namespace {

gpu::Device& device() {
  static gpu::Device shared({.name = "", .validation = true});
  return shared;
}

}  // namespace

std::string device_name() {
  return device().info().name + ", " + device().info().driver;
}

DeviceRun run_on_device(const std::vector<const Program*>& programs, const std::vector<std::uint32_t>& inputs,
                        Compiler compiler) {
  const std::size_t sets = inputs.size() / kInputs;
  shaders::CompileRequest request;
  request.file = "programs.hlsl";
  request.text = shader_text(programs);
  request.prepare = true;
  DeviceRun result;
  shaders::SpirvModule module;
  try {
    module =
        compiler == Compiler::fxc ? shaders::module_by_fxc(request) : shaders::module_by_glslang(request);
  } catch (const std::exception& error) {
    (compiler == Compiler::fxc ? result.refusal : result.error) = error.what();
    return result;
  }
  const gpu::Buffer in(device(), std::span<const std::uint32_t>(inputs));
  const gpu::Buffer out(device(), programs.size() * sets * kOutputs * sizeof(std::uint32_t));
  gpu::ComputePass pass(device(), {.spirv = module});
  for (const shaders::Resource& resource : shaders::reflect(module).resources)
    pass.bindings().buffer(resource.name, resource.name == "In" ? in : out);
  pass.dispatch({static_cast<std::uint32_t>(sets), 1, 1});
  for (const std::string& message : device().validation_log()->messages()) result.error += message + "\n";
  result.words = out.download<std::uint32_t>();
  return result;
}

}  // namespace penumbra::programs
