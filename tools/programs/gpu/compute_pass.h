// A compute shader that can run repeatedly: the pipeline is compiled once, at the first dispatch.
//
//   ComputePass resolve(device, {.spirv = words});
//   resolve.bindings().image("_ShadowMap", atlas);
//   resolve.bindings().buffer("_Visibility", visibility);
//   std::vector<double> ns = resolve.dispatch({60, 34, 1}, 5);
#pragma once

#include <array>
#include <vector>

#include "gpu/bindings.h"

namespace penumbra::gpu {

struct ComputeShader {
  std::vector<std::uint32_t> spirv;  // must be valid: shaders::compile's result is
  std::string entry = "Main";
};

struct ComputeState;

class ComputePass {
 public:
  ComputePass(const Device& device, const ComputeShader& shader);

  Bindings& bindings() { return bindings_; }
  Bindings more_bindings() const;  // for another step of a Sequence

  // Runs `repeat` times, each its own submission, and returns each one's time on the device in nanoseconds:
  // by timestamps around the dispatch where the device has them, else by the wall-clock time of the
  // submission. Throws as Sequence does.
  std::vector<double> dispatch(std::array<std::uint32_t, 3> groups, int repeat = 1);

  const std::shared_ptr<ComputeState>& state() const { return state_; }

 private:
  std::shared_ptr<ComputeState> state_;
  Bindings bindings_;
};

}  // namespace penumbra::gpu
