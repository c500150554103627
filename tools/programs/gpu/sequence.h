// Several passes in one submission, in the order in which they were added, with the barriers that their reads
// and writes need.
//
//   Sequence frame(device);
//   frame.draw(casters, casters.bindings(), {{}, {&atlas}}, tiles);
//   frame.dispatch(blur, horizontal, {32, 32, 1});
//   frame.dispatch(blur, vertical, {32, 32, 1});   // another Bindings of the same pass
//   std::vector<double> ns = frame.run();
#pragma once

#include "gpu/compute_pass.h"
#include "gpu/raster_pass.h"

namespace penumbra::gpu {

struct SequenceState;

class Sequence {
 public:
  explicit Sequence(const Device& device) : Sequence(device.state()) {}
  explicit Sequence(const std::shared_ptr<DeviceState>& device);  // for this folder

  // The bindings are those at the time of the call; run() throws std::logic_error when they have been
  // replaced since. Uniforms may change from run to run. These throw std::invalid_argument for work that no
  // device does, and std::logic_error where a shader reads a resource to which nothing is bound.
  void dispatch(const ComputePass& pass, const Bindings& bindings, std::array<std::uint32_t, 3> groups);
  void draw(const RasterPass& pass, const Bindings& bindings, const RasterTargets& targets,
            const std::vector<RasterTile>& tiles, const VertexStreams& streams = {});
  // Clears every texel of every level and layer: each channel, or the depth. For integer formats only 0 is
  // allowed.
  void clear(const Image& image, float value);

  // Submits once. Returns the time of each step on the device in nanoseconds, from the end of all steps
  // before it, waits included, to its own: the sum is the time of the whole sequence. Without timestamps the
  // first has the wall-clock time of all and the others 0. Throws EnvironmentError on timeout or device loss.
  std::vector<double> run();

  std::size_t size() const;  // number of steps

  // Returns for each step of the last run whether it had to wait for an earlier one or for an image's layout.
  const std::vector<bool>& waited() const;

 private:
  std::shared_ptr<SequenceState> state_;
};

}  // namespace penumbra::gpu
