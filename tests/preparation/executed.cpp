#include "preparation/executed.h"

#include <span>
#include <stdexcept>

#include "gpu/compute_pass.h"
#include "gpu/resources.h"
#include "preparation/emitted.h"
#include "preparation/validated_device.h"
#include "shaders/module_of.h"
#include "shaders/reflect.h"

namespace penumbra::preparation {
namespace {

shaders::CompileRequest request_of(const Execution& execution, bool prepare) {
  shaders::CompileRequest request;
  request.file = "executed.hlsl";
  request.text = "StructuredBuffer<float> In; RWStructuredBuffer<float> Out;\n" + execution.body;
  request.prepare = prepare;
  return request;
}

// GLSL puts "_1" behind the name of a buffer that is its block's as well.
std::string plain_name(const std::string& name) {
  return name.size() > 2 && name.ends_with("_1") ? name.substr(0, name.size() - 2) : name;
}

std::vector<float> run(const Execution& execution, const std::vector<std::uint32_t>& spirv,
                       const std::string& entry) {
  const gpu::Buffer in(device(), std::span<const float>(execution.in));
  const gpu::Buffer out(device(), execution.outputs * sizeof(float));
  gpu::ComputePass pass(device(), {.spirv = spirv, .entry = entry});
  for (const shaders::Resource& resource : shaders::reflect(spirv).resources) {
    const std::string name = plain_name(resource.name);
    const auto uniform = execution.uniforms.find(name);
    if (name == "In") {
      pass.bindings().buffer(resource.name, in);
    } else if (name == "Out") {
      pass.bindings().buffer(resource.name, out);
    } else if (uniform != execution.uniforms.end() &&
               resource.kind == shaders::ResourceKind::storage_buffer) {
      pass.bindings().buffer(resource.name, gpu::Buffer(device(), std::span<const float>(uniform->second)));
    } else if (uniform != execution.uniforms.end()) {
      pass.bindings().uniform_bytes(resource.name, std::as_bytes(std::span<const float>(uniform->second)));
    } else if (resource.kind == shaders::ResourceKind::storage_image) {
      pass.bindings().image(resource.name, gpu::Image(device(), gpu::Format::rgba32f, 8, 8));
    } else {
      throw std::runtime_error("nothing is given for '" + resource.name + "'");
    }
  }
  pass.dispatch({1, 1, 1});
  for (const std::string& message : device().validation_log()->messages()) throw std::runtime_error(message);
  return out.download<float>();
}

}  // namespace

std::vector<float> run_prepared(const Execution& execution) {
  return run(execution, shaders::module_by_glslang(request_of(execution, true)), "Main");
}

std::vector<float> run_unprepared(const Execution& execution) {
  return run(execution, shaders::module_by_glslang(request_of(execution, false)), "Main");
}

std::vector<float> run_through(const Execution& execution, shaders::Target target) {
  return run(execution, through_target(shaders::module_by_glslang(request_of(execution, true)), target),
             "main");
}

std::vector<float> run_by_fxc(const Execution& execution) {
  return run(execution, shaders::module_by_fxc(request_of(execution, true)), "Main");
}

std::vector<float> run_by_fxc_through(const Execution& execution, shaders::Target target) {
  return run(execution, through_target(shaders::module_by_fxc(request_of(execution, true)), target), "main");
}

}  // namespace penumbra::preparation
