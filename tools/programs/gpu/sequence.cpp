#include "gpu/sequence.h"

#include <stdexcept>

#include "gpu/pass_state.h"

namespace penumbra::gpu {
namespace {

constexpr Access transfer_write{vk::PipelineStageFlagBits::eTransfer, vk::AccessFlagBits::eTransferWrite,
                                true};

}  // namespace

SequenceStep step_with(const Bindings& bindings, const PassInterface& interface,
                       vk::PipelineBindPoint point) {
  const std::shared_ptr<BindingsState>& state = bindings.state();
  if (state->interface.get() != &interface) throw std::logic_error("the bindings are another pass's");
  state->require_bound();
  SequenceStep step;
  step.bindings = state;
  step.point = point;
  step.revision = state->revision;
  state->add_uses(step.uses);
  return step;
}

Sequence::Sequence(const std::shared_ptr<DeviceState>& device) : state_(std::make_shared<SequenceState>()) {
  state_->device = device;
}

void Sequence::dispatch(const ComputePass& pass, const Bindings& bindings,
                        std::array<std::uint32_t, 3> groups) {
  const std::shared_ptr<ComputeState> compute = pass.state();
  for (std::size_t axis = 0; axis < groups.size(); ++axis) {
    if (groups[axis] == 0 || groups[axis] > state_->device->limits.maxComputeWorkGroupCount[axis])
      throw std::invalid_argument("a dispatch of " + std::to_string(groups[axis]) + " groups along axis " +
                                  std::to_string(axis));
  }
  SequenceStep step = step_with(bindings, *compute->interface, vk::PipelineBindPoint::eCompute);
  step.used = compute;
  step.record = [compute, groups](const vk::raii::CommandBuffer& commands) {
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, compute->pipeline());
    commands.dispatch(groups[0], groups[1], groups[2]);
  };
  state_->steps.push_back(std::move(step));
}

void Sequence::draw(const RasterPass& pass, const Bindings& bindings, const RasterTargets& targets,
                    const std::vector<RasterTile>& tiles, const VertexStreams& streams) {
  state_->steps.push_back(raster_step(pass.state(), bindings, targets, tiles, streams));
}

void Sequence::clear(const Image& image, float value) {
  const std::shared_ptr<ImageState> state = image.state();
  if (is_integer(state->shape.format) && value != 0.0F)
    throw std::invalid_argument("images of integers are cleared to 0");
  constexpr vk::ImageLayout layout = vk::ImageLayout::eTransferDstOptimal;
  SequenceStep step;
  step.uses.images.push_back({state, state->whole(), layout, transfer_write});
  step.used = state;
  step.record = [state, value](const vk::raii::CommandBuffer& commands) {
    const vk::ImageSubresourceRange range = state->range(state->whole());
    if (is_depth(state->shape.format))
      commands.clearDepthStencilImage(*state->image, layout, vk::ClearDepthStencilValue(value, 0), range);
    else
      commands.clearColorImage(*state->image, layout,
                               vk::ClearColorValue(std::array{value, value, value, value}), range);
  };
  state_->steps.push_back(std::move(step));
}

std::vector<double> Sequence::run() {
  DeviceState& device = *state_->device;
  for (const SequenceStep& step : state_->steps)
    if (step.bindings && step.bindings->revision != step.revision)
      throw std::logic_error("a resource was replaced after its bindings were put into a sequence");
  state_->waited.assign(state_->steps.size(), false);
  const auto record = [this, &device](const vk::raii::CommandBuffer& commands) {
    Barriers barriers;
    std::uint32_t number = 0;
    for (const SequenceStep& step : state_->steps) {
      state_->waited[number] = barriers.before(step.uses, commands);
      if (step.bindings) step.bindings->use(step.point, commands);
      if (number == 0) device.mark_begin(commands);
      step.record(commands);
      device.mark_end(commands, number);
      ++number;
    }
  };
  return guarded(device, "run a sequence of passes", [&] {
    for (const SequenceStep& step : state_->steps)
      if (step.bindings) step.bindings->write_descriptors();
    return device.submit(record, state_, std::uint32_t(state_->steps.size()));
  });
}

std::size_t Sequence::size() const {
  return state_->steps.size();
}

const std::vector<bool>& Sequence::waited() const {
  return state_->waited;
}

}  // namespace penumbra::gpu
