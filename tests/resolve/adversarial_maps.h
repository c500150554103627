// Maps and receivers made to mislead code that decides for blocks of texels and clusters of receivers at
// once.
//
// The camera looks along the light, straight or at a slant, with a place in the map for each pixel: so the
// image of its depths may put a receiver at any depth below any texel, and its neighbours anywhere else.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/matrix.hpp>
#include <limits>
#include <string>
#include <vector>

#include "resolve/camera_image.h"
#include "resolve/synthetic_frame.h"

namespace penumbra::resolve {

inline std::uint32_t hash_of(int x, int y, int salt) {
  std::uint32_t bits = static_cast<std::uint32_t>(x) * 0x9E3779B1U ^
                       static_cast<std::uint32_t>(y) * 0x85EBCA77U ^
                       static_cast<std::uint32_t>(salt) * 0xC2B2AE3DU;
  for (int i = 0; i < 2; ++i) bits = (bits ^ bits >> 15) * 0x2C1B3C6DU;
  return bits ^ bits >> 16;
}
inline double share_of(int x, int y, int salt) {
  return std::ldexp(static_cast<double>(hash_of(x, y, salt)), -32);
}

// The height is 0 at the far end of the map and 1 at the light's; a texel may hold anything.
using TexelHeight = std::function<double(int x, int y)>;

struct NamedHeights {
  std::string name;
  TexelHeight height;
};

inline std::vector<NamedHeights> adversarial_maps() {
  std::vector<NamedHeights> maps;
  const auto add = [&](const std::string& name, TexelHeight height) {
    maps.push_back({name, std::move(height)});
  };
  add("random texels", [](int x, int y) { return share_of(x, y, 1); });
  add("random texels of a roof", [](int x, int y) { return 0.5 + 0.1 * share_of(x, y, 2); });
  add("one texel in fifty", [](int x, int y) { return hash_of(x, y, 3) % 50 == 0 ? 0.9 : 0.1; });
  for (const int period : {1, 2, 3, 8})
    add("checkerboard of " + std::to_string(period),
        [period](int x, int y) { return (x / period + y / period) % 2 == 0 ? 0.3 : 0.6; });
  add("slanted plane", [](int x, int y) { return 0.1 + 0.003 * x + 0.0001 * y; });
  add("two slanted planes",
      [](int x, int y) { return y / 64 % 2 == 0 ? 0.1 + 0.003 * x : 0.9 - 0.0015 * x; });
  add("rough slanted plane",
      [](int x, int y) { return 0.1 + 0.002 * x + 0.001 * y + 1e-4 * share_of(x, y, 4); });
  add("steps", [](int x, int y) { return 0.1 + 0.05 * (x / 16) + 0.01 * (y / 4 % 3); });
  add("single texels", [](int x, int y) { return x % 37 == 5 && y % 23 == 7 ? 0.7 : 0.2; });
  add("low single texels", [](int x, int y) { return x % 37 == 5 && y % 23 == 7 ? 0.2005 : 0.2; });
  add("single holes", [](int x, int y) { return x % 37 == 5 && y % 23 == 7 ? 0.05 : 0.6; });
  add("holes in a slanted roof",
      [](int x, int y) { return x % 37 == 5 && y % 23 == 7 ? 0.05 : 0.3 + 0.002 * x; });
  add("edge of a roof", [](int x, int y) { return x + y / 3 > 150 ? 0.7 : 0.1; });
  add("walls of every height",
      [](int x, int y) { return x % 40 < 3 ? 0.1 + 0.8 * share_of(x / 40, y / 20, 5) : 0.1; });
  add("NaN, infinities and beyond", [](int x, int y) {
    const double odd[] = {std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity(),
                          -0.5,
                          1.5,
                          -0.0,
                          1e-42,
                          1e38};
    const std::uint32_t kind = hash_of(x, y, 6) % 64;
    return kind < 8 ? odd[kind] : y < 128 ? 0.2 : 0.6;
  });
  add("one NaN in a roof", [](int x, int y) {
    return x % 64 == 9 && y % 64 == 9 ? std::numeric_limits<double>::quiet_NaN() : 0.6;
  });
  add("far end", [](int, int) { return 0.0; });
  add("light's end", [](int, int) { return 1.0; });
  add("either end", [](int x, int y) { return x / 50 % 2 == y / 70 % 2 ? 0.0 : 1.0; });
  return maps;
}

// The heights of receivers at a pixel and the texel below it, from the map's own height there.
using ReceiverHeight = std::function<double(int column, int row, glm::dvec2 texel, double map)>;

struct NamedReceivers {
  std::string name;
  ReceiverHeight height;
};

inline std::vector<NamedReceivers> adversarial_receivers() {
  std::vector<NamedReceivers> receivers;
  const auto add = [&](const std::string& name, ReceiverHeight height) {
    receivers.push_back({name, std::move(height)});
  };
  const auto finite = [](double map) { return std::isfinite(map) ? std::min(std::max(map, 0.0), 1.0) : 0.5; };
  add("flat ground", [](int, int, glm::dvec2, double) { return 0.15; });
  add("slanted ground",
      [](int, int, glm::dvec2 texel, double) { return 0.05 + 0.0015 * texel.x + 0.0005 * texel.y; });
  add("a slanted plane in each tile", [](int column, int row, glm::dvec2 texel, double) {
    const int x = column / 8, y = row / 8;
    return share_of(x, y, 11) + 0.002 * (share_of(x, y, 12) - 0.5) * (texel.x - 128.0) +
           0.002 * (share_of(x, y, 13) - 0.5) * (texel.y - 128.0);
  });
  add("two levels in each tile", [](int column, int row, glm::dvec2, double) {
    return (column + row) % 8 < 4 ? 0.05 + 0.2 * share_of(column / 8, row / 8, 14) : 0.45;
  });
  add("random pixels", [](int column, int row, glm::dvec2, double) { return share_of(column, row, 15); });
  add("noisy ground", [](int column, int row, glm::dvec2 texel, double) {
    return 0.1 + 0.001 * texel.x +
           std::exp2(-24.0 + 16.0 * share_of(column / 64, row / 64, 16)) * share_of(column, row, 17);
  });
  add("just below the map", [finite](int column, int row, glm::dvec2, double map) {
    return finite(map) - std::exp2(-20.0 + 16.0 * share_of(column / 16, row / 16, 18));
  });
  add("just above the map", [finite](int column, int row, glm::dvec2, double map) {
    return finite(map) + std::exp2(-24.0 + 16.0 * share_of(column / 16, row / 16, 19));
  });
  // Half of a tile's pixels lie below the map, half above it, so little that one plane may stand for both.
  add("both sides of the map", [finite](int column, int row, glm::dvec2, double map) {
    const double away = std::exp2(-16.0 + 9.0 * share_of(column / 8, row / 8, 22));
    return finite(map) + (column % 8 < 4 ? away : -away);
  });
  add("a ridge through the map in each tile", [finite](int column, int row, glm::dvec2, double map) {
    const double slope = std::exp2(-16.0 + 9.0 * share_of(column / 8, row / 8, 23));
    return finite(map) + slope * (2.0 - std::abs(column % 8 - 3.5));
  });
  add("both ends of the map", [](int column, int row, glm::dvec2, double) {
    const double off_the_end = std::exp2(-22.0 + 18.0 * share_of(column / 8, row / 8, 20));
    return hash_of(column / 8, row / 8, 21) % 2 == 0 ? off_the_end : 1.0 - off_the_end;
  });
  return receivers;
}

// The way in which a camera along the light sees a cascade's tile.
struct ViewOfTile {
  glm::dvec2 first;            // tile UV of the image's first corner
  glm::dvec2 span;             // tile UV
  glm::dvec2 slant{0.0, 0.0};  // tile UV for each unit of depth
  int width = 320;
  int height = 200;
};

inline float stored_height(double height, bool reversed_z) {
  return static_cast<float>(reversed_z ? height : 1.0 - height);
}

inline CameraImage camera_along_light(const scene::Frame& frame, int cascade_index, const ViewOfTile& view,
                                      const TexelHeight& map, const ReceiverHeight& receiver) {
  const parameters::Cascade& cascade = frame.cascades.cascades.at(static_cast<std::size_t>(cascade_index));
  const glm::dvec2 corner(cascade.offset_scale), size(cascade.offset_scale.z, cascade.offset_scale.w);
  glm::dmat4 to_shadow(1.0);
  to_shadow[0] = glm::dvec4(size.x * view.span.x, 0.0, 0.0, 0.0);
  to_shadow[1] = glm::dvec4(0.0, size.y * view.span.y, 0.0, 0.0);
  to_shadow[2] = glm::dvec4(size * view.slant, 1.0, 0.0);
  to_shadow[3] = glm::dvec4(corner + size * (view.first - 0.5 * view.slant), 0.0, 1.0);
  CameraImage image{
      view.width, view.height, RowOrder::top_first, {}, glm::inverse(cascade.world_to_shadow) * to_shadow};
  for (int row = 0; row < view.height; ++row)
    for (int column = 0; column < view.width; ++column) {
      const glm::dvec2 uv =
          view.first + view.span * (glm::dvec2(column, row) + 0.5) / glm::dvec2(view.width, view.height);
      const glm::dvec2 texel = uv * static_cast<double>(frame.cascades.tile_resolution);
      const double below = map(static_cast<int>(std::floor(texel.x)), static_cast<int>(std::floor(texel.y)));
      image.depth.push_back(stored_height(receiver(column, row, texel, below), frame.cascades.reversed_z));
    }
  return image;
}

}  // namespace penumbra::resolve
