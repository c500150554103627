// The steps that passes add to a submission. Internal to this folder.
#pragma once

#include <functional>
#include <vector>

#include "gpu/bindings_state.h"
#include "gpu/resource_uses.h"
#include "gpu/sequence.h"

namespace penumbra::gpu {

struct SequenceStep {
  ResourceUses uses;
  std::shared_ptr<BindingsState> bindings;  // null if there are none
  std::uint64_t revision = 0;               // revision of the bindings
  vk::PipelineBindPoint point = vk::PipelineBindPoint::eCompute;
  std::function<void(const vk::raii::CommandBuffer&)> record;
  std::shared_ptr<void> used;  // kept alive
};

struct SequenceState {
  std::shared_ptr<DeviceState> device;
  std::vector<SequenceStep> steps;
  std::vector<bool> waited;
};

// Returns the step without its `record`; throws std::logic_error for bindings of another pass, and for empty
// ones.
SequenceStep step_with(const Bindings& bindings, const PassInterface& interface, vk::PipelineBindPoint point);

}  // namespace penumbra::gpu
