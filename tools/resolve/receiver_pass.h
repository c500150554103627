// A module that runs once per receiver of a frame: a compute shader, or a fragment shader drawn over the
// picture.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gpu/compute_pass.h"
#include "gpu/raster_pass.h"

namespace penumbra::resolve {

class ReceiverPass {
 public:
  // Entry points as Resolve.hlsl names them. Without a vertex shader `module` is a compute shader.
  ReceiverPass(const gpu::Device& device, const std::vector<std::uint32_t>& vertex,
               const std::vector<std::uint32_t>& module);

  gpu::Bindings& bindings();

  // The time of each repeat in nanoseconds, over a picture of that size.
  std::vector<double> run(int width, int height, int repeats);

 private:
  std::vector<double> draw(int width, int height, int repeats);

  const gpu::Device* device_;
  std::optional<gpu::ComputePass> compute_;  // this or
  std::optional<gpu::RasterPass> raster_;    // that
  std::optional<gpu::Image> target_;         // of the last picture's size; its content means nothing
};

}  // namespace penumbra::resolve
