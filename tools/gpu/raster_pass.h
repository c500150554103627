// Triangles into a depth image and up to two colour images, tile by tile.
//
// Vertices are pulled: the vertex shader reads storage buffers by SV_VertexID; there is no vertex input.
// Coordinates are Vulkan's: clip y = -1 is row 0 of the image, clip depth 0 .. 1 is what the image stores.
// Both faces are drawn; one sample per pixel, at its centre.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/bindings.h"

namespace penumbra::gpu {

// Which fragment survives: the nearer one, in conventional or reversed Z.
enum class DepthTest { less, greater };

struct RasterShaders {
  std::vector<std::uint32_t> vertex;
  std::vector<std::uint32_t> fragment;  // empty: depth only
  std::string vertex_entry = "Main";
  std::string fragment_entry = "Main";
  std::vector<Format> colours;  // of the targets, at most two
  std::optional<Format> depth;
  DepthTest depth_test = DepthTest::less;
  // Added to every fragment's depth, toward larger ones: the first times the format's smallest step, the
  // second times the depth's steepest change from pixel to pixel.
  float constant_depth_bias = 0.0F;
  float slope_depth_bias = 0.0F;
  bool depth_clamp = false;  // clamp fragments to the depth range instead of clipping triangles
};

struct RasterTargets {
  std::vector<const Image*> colours;  // cleared to 0
  const Image* depth = nullptr;       // cleared to clear_depth
  float clear_depth = 1.0F;
};

// One draw into a rectangle of the targets: viewport and scissor both. The push constants (at most 128
// bytes) are both stages' to read.
struct RasterTile {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  std::uint32_t vertex_count = 0;
  std::vector<std::byte> push_constants;
};

struct RasterState;

class RasterPass {
 public:
  // Throws EnvironmentError when depth_clamp is asked for and absent, std::invalid_argument for no target.
  RasterPass(const Device& device, const RasterShaders& shaders);
  ~RasterPass();
  RasterPass(RasterPass&&) noexcept;
  RasterPass& operator=(RasterPass&&) noexcept;

  Bindings& bindings();

  // Clears the targets, draws all tiles in one submission, and returns its time in nanoseconds.
  double draw(const RasterTargets& targets, const std::vector<RasterTile>& tiles);

 private:
  std::shared_ptr<RasterState> state_;
};

}  // namespace penumbra::gpu
