// Draws triangles into a depth image and colour images, tile by tile.
//
// Vertices are read from vertex buffers, one for each input of the vertex shader, or the shader reads storage
// buffers by SV_VertexID and has no inputs. Coordinates are Vulkan's: clip y = -1 is row 0 of the image, and
// the image stores clip depth 0 .. 1. Both faces are drawn. The front one is clockwise where row 0 is the
// top, as in Unity.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gpu/bindings.h"

namespace penumbra::gpu {

// The test by which a fragment survives, of its depth against the stored one. The nearer one is less in
// conventional and greater in reversed Z.
enum class DepthTest { less, greater, less_equal, greater_equal, equal, always };

// The test of the reference against a pixel's stencil: `less` passes where the reference is the smaller one.
enum class StencilTest { never, less, equal, less_equal, greater, not_equal, greater_equal, always };

// The result of a new colour and the stored one: the new one; the sum; the smaller or larger of each channel;
// a mixture by the new one's alpha.
enum class Blend { none, add, smallest, largest, alpha };

// The new value of a pixel's stencil: the same; 0; the reference; one more or less, which stops at 255 and 0
// or continues at the other end; its complement.
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

// The stencil state for the triangles of one face. The test compares the reference with the pixel's stencil,
// both under the read mask. The operations apply where this test fails, where the depth test fails, and where
// both pass.
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

// An input of the vertex shader: so many floats for each vertex, without gaps in their buffer. Further
// components that the shader declares are 0, and a fourth one is 1.
struct VertexInput {
  std::uint32_t location = 0;
  int components = 4;
};

struct RasterShaders {
  std::vector<std::uint32_t> vertex;
  std::vector<std::uint32_t> fragment;  // if empty, depth only
  std::string vertex_entry = "Main";
  std::string fragment_entry = "Main";
  std::vector<VertexInput> inputs;
  std::vector<Format> colours;  // formats of the targets, as many as the device has attachments
  std::vector<Blend> blends;    // one for each target; none if empty
  std::optional<Format> depth;
  DepthTest depth_test = DepthTest::less;
  bool depth_write = true;
  // These are added to every fragment's depth, toward larger ones: the first times the format's smallest
  // step, the second times the depth's steepest change from pixel to pixel.
  float constant_depth_bias = 0.0F;
  float slope_depth_bias = 0.0F;
  bool depth_clamp = false;             // clamps fragments to the depth range instead of clipping triangles
  int samples = 1;                      // samples of each pixel of the targets
  bool shade_each_sample = false;       // if false, once for all samples of a pixel
  bool keep = false;                    // keeps the contents of the targets instead of clearing them
  bool keep_depth = false;              // keeps depth and stencil even if `keep` is false
  std::optional<StencilState> stencil;  // for a depth target with stencil
  bool resolve = false;                 // resolves colours with several samples into RasterTargets::resolves
};

// A mip level of one layer of an image. Null means none.
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
  std::vector<std::array<float, 4>> clear_colours = {};  // one for each; 0 if empty
  std::vector<RasterTarget> resolves = {};  // images of one sample: each pixel's mean, for each colour
};

// The buffers from which a draw reads its vertices. They have to outlive the sequence that they are put into.
struct VertexStreams {
  std::vector<const Buffer*> inputs;  // one for each of RasterShaders::inputs, in their order
  const Buffer* indices = nullptr;    // 32 bits each; null: vertices in order
};

// A draw into a rectangle of the targets, which is viewport and scissor both. Both stages can read the push
// constants (at most 128 bytes).
struct RasterTile {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  std::uint32_t vertex_count = 0;  // number of vertices, or of indices
  std::vector<std::byte> push_constants;
};

struct RasterState;

class RasterPass {
 public:
  // Throws EnvironmentError for what the device lacks: depth clamp, shading of each sample, so many colours.
  // Throws std::invalid_argument if there is no target, and for stencil without a target that has one.
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
