#include "gpu/compute_pass.h"

#include <stdexcept>

#include "gpu/pass_state.h"
#include "gpu/sequence.h"

namespace penumbra::gpu {
namespace {

std::shared_ptr<ComputeState> make_state(const Device& device, const ComputeShader& shader) {
  if (shader.spirv.empty()) throw std::invalid_argument("a compute pass without a shader");
  auto state = std::make_shared<ComputeState>();
  std::vector<StageModule> modules{{shader.spirv, vk::ShaderStageFlagBits::eCompute}};
  state->interface = make_interface(device.state(), modules, 0);
  state->shader = {std::move(modules.front().spirv), shader.entry};
  return state;
}

}  // namespace

vk::Pipeline ComputeState::pipeline() {
  if (*pipeline_) return *pipeline_;
  const vk::raii::Device& device = interface->device->device;
  const vk::raii::ShaderModule module(device, vk::ShaderModuleCreateInfo({}, shader.spirv));
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module,
                                                shader.entry.c_str());
  pipeline_ = vk::raii::Pipeline(device, nullptr,
                                 vk::ComputePipelineCreateInfo({}, stage, *interface->pipeline_layout));
  return *pipeline_;
}

ComputePass::ComputePass(const Device& device, const ComputeShader& shader)
    : state_(make_state(device, shader)), bindings_(state_->interface) {}

Bindings ComputePass::more_bindings() const {
  return Bindings(state_->interface);
}

std::vector<double> ComputePass::dispatch(std::array<std::uint32_t, 3> groups, int repeat) {
  Sequence once(state_->interface->device);
  once.dispatch(*this, bindings_, groups);
  std::vector<double> nanoseconds;
  for (int run = 0; run < repeat; ++run) nanoseconds.push_back(once.run().front());
  return nanoseconds;
}

}  // namespace penumbra::gpu
