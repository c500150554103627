#include "gpu/compute_pass.h"

#include <algorithm>
#include <stdexcept>

#include "gpu/bindings_state.h"

namespace penumbra::gpu {

struct ComputeState {
  ComputeState(const Device& device, ComputeShader given) : bindings(device), shader(std::move(given)) {}

  Bindings bindings;
  ComputeShader shader;
  vk::raii::Pipeline pipeline = nullptr;

  void make_pipeline();
};

void ComputeState::make_pipeline() {
  BindingsState& bound = *bindings.state();
  require_bound(bound, shader.spirv);
  bound.freeze(vk::ShaderStageFlagBits::eCompute, 0);
  const vk::raii::ShaderModule module(bound.device->device, vk::ShaderModuleCreateInfo({}, shader.spirv));
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module,
                                                shader.entry.c_str());
  pipeline = vk::raii::Pipeline(bound.device->device, nullptr,
                                vk::ComputePipelineCreateInfo({}, stage, *bound.pipeline_layout));
}

ComputePass::ComputePass(const Device& device, const ComputeShader& shader)
    : state_(std::make_shared<ComputeState>(device, shader)) {
  if (shader.spirv.empty()) throw std::invalid_argument("a compute pass without a shader");
}

ComputePass::~ComputePass() = default;
ComputePass::ComputePass(ComputePass&&) noexcept = default;
ComputePass& ComputePass::operator=(ComputePass&&) noexcept = default;

Bindings& ComputePass::bindings() {
  return state_->bindings;
}

std::vector<double> ComputePass::dispatch(std::array<std::uint32_t, 3> groups, int repeat) {
  BindingsState& bound = *state_->bindings.state();
  DeviceState& device = *bound.device;
  for (std::size_t axis = 0; axis < groups.size(); ++axis) {
    if (groups[axis] == 0 || groups[axis] > device.limits.maxComputeWorkGroupCount[axis]) {
      throw std::invalid_argument("a dispatch of " + std::to_string(groups[axis]) + " groups along axis " +
                                  std::to_string(axis));
    }
  }
  return guarded(device, "run a compute pass", [&] {
    if (!*state_->pipeline) state_->make_pipeline();
    bound.write_descriptors();
    std::vector<double> nanoseconds;
    nanoseconds.reserve(static_cast<std::size_t>(std::max(repeat, 0)));
    for (int run = 0; run < repeat; ++run) {
      nanoseconds.push_back(device.submit(
          [&](const vk::raii::CommandBuffer& commands) {
            bound.use(vk::PipelineBindPoint::eCompute, commands);
            commands.bindPipeline(vk::PipelineBindPoint::eCompute, *state_->pipeline);
            device.mark_begin(commands);
            commands.dispatch(groups[0], groups[1], groups[2]);
            device.mark_end(commands);
          },
          state_));
    }
    return nanoseconds;
  });
}

}  // namespace penumbra::gpu
