// The Vulkan side of a ComputePass. Internal to this folder.
#pragma once

#include "gpu/compute_pass.h"
#include "gpu/pass_interface.h"

namespace penumbra::gpu {

struct ComputeState {
  std::shared_ptr<PassInterface> interface;
  ComputeShader shader;

  vk::Pipeline pipeline();  // made when first needed

 private:
  vk::raii::Pipeline pipeline_ = nullptr;
};

}  // namespace penumbra::gpu
