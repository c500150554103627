// Triangles into a depth image and colour images, tile by tile.
//
// Vertices are read from vertex buffers, one for each input of the vertex shader, or the shader reads storage
// buffers by SV_VertexID and has no inputs.
// Coordinates are Vulkan's: clip y = -1 is row 0 of the image, clip depth 0 .. 1 is what the image stores.
// Both faces are drawn. The front one is clockwise where row 0 is the top, as Unity has it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/bindings.h"

namespace penumbra::gpu {

// Which fragment survives, by its depth against the one that is there. The nearer one: less in conventional
// and greater in reversed Z.
enum class DepthTest { less, greater, less_equal, greater_equal, equal, always };

// The reference against a pixel's stencil: less where the reference is the smaller one.
enum class StencilTest { never, less, equal, less_equal, greater, not_equal, greater_equal, always };

// What becomes of a colour and the one that is there: replaced; added; the smaller or larger of each channel;
// mixed by the new one's alpha.
enum class Blend { none, add, smallest, largest, alpha };

// What becomes of the stencil of a pixel: kept; 0; the reference; one more or less, which stops at 255 and 0
// or goes on at the other end; its complement.
enum class StencilOperation {
  keep,
  zero,
  replace,
  increment,
  decrement,
  increment_wrap,
  decrement_wrap,
  invert
};

// Of the triangles of one face: whether a fragment passes, by comparing the reference with the pixel's
// stencil, both under the read mask, and what becomes of the stencil where this test fails, where the depth
// test does, and where both pass.
struct StencilFace {
  StencilTest test = StencilTest::always;
  StencilOperation fail = StencilOperation::keep;
  StencilOperation depth_fail = StencilOperation::keep;
  StencilOperation pass = StencilOperation::keep;

  bool operator==(const StencilFace&) const = default;
};

struct StencilState {
  StencilFace front;
  StencilFace back;
  std::uint8_t reference = 0;
  std::uint8_t read_mask = 255;
  std::uint8_t write_mask = 255;

  bool operator==(const StencilState&) const = default;
};

// An input of the vertex shader: so many floats for each vertex, without gaps in their buffer. What the
// shader declares beyond them is 0, and 1 in a fourth component.
struct VertexInput {
  std::uint32_t location = 0;
  int components = 4;
};

struct RasterShaders {
  std::vector<std::uint32_t> vertex;
  std::vector<std::uint32_t> fragment;  // empty: depth only
  std::string vertex_entry = "Main";
  std::string fragment_entry = "Main";
  std::vector<VertexInput> inputs;
  std::vector<Format> colours;  // of the targets, as many as the device has attachments
  std::vector<Blend> blends;    // of each; empty: none
  std::optional<Format> depth;
  DepthTest depth_test = DepthTest::less;
  bool depth_write = true;
  // Added to every fragment's depth, toward larger ones: the first times the format's smallest step, the
  // second times the depth's steepest change from pixel to pixel.
  float constant_depth_bias = 0.0F;
  float slope_depth_bias = 0.0F;
  bool depth_clamp = false;             // clamp fragments to the depth range instead of clipping triangles
  int samples = 1;                      // of each pixel of the targets
  bool shade_each_sample = false;       // else once for all samples of a pixel
  bool keep = false;                    // what the targets hold, instead of clearing them
  bool keep_depth = false;              // depth and stencil, where keep is not set
  std::optional<StencilState> stencil;  // of a depth target with stencil
  bool resolve = false;                 // colours with several samples into RasterTargets::resolves
};

// One mip level of one layer of an image. Null: none.
struct RasterTarget {
  RasterTarget(const Image* target, int target_mip = 0, int target_layer = 0)
      : image(target), mip(target_mip), layer(target_layer) {}
  RasterTarget(std::nullptr_t) {}

  const Image* image = nullptr;
  int mip = 0;
  int layer = 0;
};

struct RasterTargets {
  std::vector<RasterTarget> colours;
  RasterTarget depth = nullptr;
  float clear_depth = 1.0F;
  std::vector<std::array<float, 4>> clear_colours = {};  // of each; empty: 0
  std::vector<RasterTarget> resolves = {};               // of one sample: each pixel's mean, for each colour
};

// What a draw reads its vertices from. They have to outlive the sequence that they are put into.
struct VertexStreams {
  std::vector<const Buffer*> inputs;  // of RasterShaders::inputs, in their order
  const Buffer* indices = nullptr;    // 32 bits each; null: vertices in order
};

// One draw into a rectangle of the targets: viewport and scissor both. The push constants (at most 128
// bytes) are both stages' to read.
struct RasterTile {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  std::uint32_t vertex_count = 0;  // of them, or of indices
  std::vector<std::byte> push_constants;
};

struct RasterState;

class RasterPass {
 public:
  // Throws EnvironmentError for what the device lacks: depth clamp, shading of each sample, so many colours;
  // std::invalid_argument for no target, and for stencil without a target that has one.
  RasterPass(const Device& device, const RasterShaders& shaders);

  Bindings& bindings() { return bindings_; }
  Bindings more_bindings() const;  // for another step of a Sequence

  // Draws all tiles in one submission, and returns its time in nanoseconds.
  double draw(const RasterTargets& targets, const std::vector<RasterTile>& tiles,
              const VertexStreams& streams = {});

  const std::shared_ptr<RasterState>& state() const { return state_; }

 private:
  std::shared_ptr<RasterState> state_;
  Bindings bindings_;
};

}  // namespace penumbra::gpu
