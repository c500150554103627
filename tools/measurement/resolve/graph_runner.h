// Runs a graph over the receivers of a frame: visibility per noise seed, fetches and written texels of every
// pass, time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "resolve/adapter_resources.h"
#include "resolve/camera_image.h"
#include "resolve/compiled_graph.h"
#include "resolve/frame_on_device.h"
#include "resolve/program_on_device.h"

namespace penumbra::resolve {

// A frame that was drawn before.
struct EarlierFrame {
  const FrameOnDevice* frame = nullptr;
  const CameraImage* camera = nullptr;
};

struct RunOptions {
  // Visibility images; graphs without noise are run once. With 0, which needs count_fetches, the modules that
  // count draw the one image, of seed 0: the driver compiles the shipped ones only where times are wanted.
  int noise_seeds = 16;
  int first_seed = 0;
  int timing_repeats = 5;  // runs whose times are kept: those of the seeds but the first, then further ones
  // Seconds of runs before the timed ones, whose times are not kept, until a GPU that was idle runs at its
  // full clock. The times of the seeds are then not kept either, since the device waits between them. If this
  // is 0, the first run alone is not timed.
  double warm_up_seconds = 0.0;
  // Whether the counts of the result are wanted. The driver compiles each program once more for them.
  bool count_fetches = false;
  // The view of the second eye, of the same size and order of rows, for graphs whose programs draw both eyes
  // at once and whose textures of the screen have two layers. The visibility then has the second eye's rows
  // after the first's.
  const CameraImage* second_eye = nullptr;
  // The frames that are drawn before each image of a graph with history, oldest first; without them its
  // history is empty. Every frame has noise of its own, in order. Times are those of a frame without history.
  std::vector<EarlierFrame> earlier{};
};

// What a pass does in a frame, in all its draws or dispatches (shaders/counted_module.h).
struct PassCounts {
  std::string pass;
  techniques::Frequency frequency = techniques::Frequency::frame;
  double fetches = 0.0;         // per pixel of the screen
  double texels_written = 0.0;  // the same
  double operations = 0.0;      // the same; scalar operations that are executed
  double invocations = 0.0;     // the same; threads or fragments
  double bytes_read = 0.0;      // the same; texels in the formats that the manifest declares
  double bytes_written = 0.0;   // the same
  int steps = 0;                // draws, or dispatches of a kernel
  // Of kernels: groups in all dispatches, and barriers that each passes, the mean over groups.
  std::optional<double> groups;
  std::optional<double> barriers_per_group;
  std::optional<double>
      fetches_per_cascade;  // fetches in one cascade, for a pass over the map or for each cascade
};

// Images have one value per receiver, row 0 at the top.
struct GraphResult {
  std::vector<std::vector<float>> visibility;  // per seed; 1 = lit
  std::vector<std::uint32_t> fetches;       // seed 0's, by the filter or by passes at the screen's resolution
  double fetches_of_others = 0.0;           // fetches of all other passes, per pixel of the screen
  std::vector<float> fetches_of_others_at;  // the share of these at each pixel; empty without such passes
  std::vector<PassCounts> passes;           // in the order in which the passes run
  std::vector<std::uint8_t> masked_out;     // 1 where the mask is below 0.5; empty without a mask
  std::vector<double> time_ns;              // times of the graph as it ships, without counting, per timed run
  std::vector<std::vector<double>>
      pass_times_ns;                        // times of each pass; empty where the device has no timestamps
  std::vector<std::string> unset_uniforms;  // read as zero because nobody provides them
};

class GraphRunner {
 public:
  GraphRunner(const gpu::Device& device, CompiledGraph graph);

  const techniques::PassGraph& graph() const { return graph_.source.graph; }

  void set_parameters(const UniformValues& parameters) { graph_.source.parameters.merge(parameters); }

  // Graphs that run over the screen or draw what the camera sees read the camera. Throws InputError when a
  // program binds a texture, sampler or buffer that neither the graph nor the harness provides. Throws
  // std::invalid_argument without a camera, or without the frame's casters or their volumes, where they are
  // needed.
  GraphResult run(const FrameOnDevice& frame, const CameraImage* camera, const RunOptions& options = {});
  GraphResult run(const FrameOnDevice& frame, const RunOptions& options = {}) {
    return run(frame, nullptr, options);
  }

 private:
  class Run;

  const gpu::Device* device_;
  CompiledGraph graph_;
  // The programs of a pass. `alpha_tested` draws casters of materials with alpha test, where that is another
  // program.
  struct Programs {
    ProgramOnDevice usual;
    std::optional<ProgramOnDevice> alpha_tested;
  };
  Programs made(std::size_t pass, ProgramOnDevice::Module module) const;
  void add_times(const std::vector<double>& of_passes, GraphResult& result) const;
  // Passes that are tested against the shadow map are made for its format.
  void fit_to(gpu::Format shadow_map);

  gpu::Format shadow_map_ = gpu::Format::depth32;
  std::vector<Programs> plain_;
  std::vector<Programs> counting_;
  AdapterResources own_;
};

}  // namespace penumbra::resolve
