// The renderer feature's passes one after the other, over a frame: what Unity would draw, with every fetch
// and every written texel of every pass counted.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "resolve/camera_image.h"
#include "resolve/frame_on_device.h"
#include "resolve/resolve.h"
#include "resolve/screen_pass.h"
#include "resolve/screen_shader.h"

namespace penumbra::resolve {

struct ScreenStep {
  std::string pass;  // of the .shader
  int scale = 1;    // pixels of the screen per pixel of its target, each way; the target's size is rounded up
  int source = -1;  // the step whose target it reads as _PenumbraSourceTexture; -1: none
};

// The last step's target is the answer and has the screen's size.
struct ScreenChainDescription {
  std::vector<ScreenStep> steps;
  int mask = -1;  // the step whose target is _PenumbraMaskTexture
  std::vector<std::string> keywords;
  UniformValues parameters;
  bool uses_noise = false;
};

struct ScreenChainResult {
  ResolveResult image;             // rows from the top; fetches: of the steps at full resolution, per pixel
  double fetches_of_others = 0.0;  // of steps at lower resolution, per pixel of the screen
  std::vector<float> fetches_of_others_at;  // the same at each pixel: its share of their texels' fetches
  std::vector<double> fetches;              // of each step, per pixel of the screen
  std::vector<double> texels_written;       // the same; outputs and stores of the step's fragments
  std::vector<std::uint8_t> masked_out;     // per pixel: the mask is 0 there; empty without a mask
};

class ScreenChain {
 public:
  // Its passes are compiled in `process`, as compile() of screen_shader.h says.
  ScreenChain(const gpu::Device& device, const shaders::PackageShader& shader,
              ScreenChainDescription description, bool reversed_z, const platform::WorkerPool& process = {});

  ScreenChainResult run(const FrameOnDevice& frame, const CameraImage& camera,
                        const ResolveOptions& options = {});

 private:
  struct Targets;
  double draw(std::vector<ScreenPass>& passes, Targets& targets, int seed);

  const gpu::Device& device_;
  ScreenChainDescription description_;
  std::vector<ScreenPass> plain_;
  std::vector<ScreenPass> counting_;
};

}  // namespace penumbra::resolve
