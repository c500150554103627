#include "scene/patterns.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace penumbra::scene {
namespace {

// Returns a number in 0..1 for a lattice point, by integer arithmetic alone (the finaliser of MurmurHash3).
double lattice(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  std::uint32_t h = x * 0x9e3779b1U ^ y * 0x85ebca6bU ^ seed * 0xc2b2ae35U;
  h = (h ^ (h >> 16)) * 0x85ebca6bU;
  h = (h ^ (h >> 13)) * 0xc2b2ae35U;
  return static_cast<double>(h ^ (h >> 16)) / 4294967295.0;
}

double smooth(double t) {
  return t * t * (3.0 - 2.0 * t);
}

// Returns one octave at (x, y) in 0..1, with cells that repeat.
double noise(double x, double y, int cells_x, int cells_y, std::uint32_t seed) {
  const double px = x * cells_x, py = y * cells_y;
  const int ix = static_cast<int>(px), iy = static_cast<int>(py);
  const auto value = [&](int dx, int dy) {
    return lattice(static_cast<std::uint32_t>((ix + dx) % cells_x),
                   static_cast<std::uint32_t>((iy + dy) % cells_y), seed);
  };
  const double tx = smooth(px - ix), ty = smooth(py - iy);
  return glm::mix(glm::mix(value(0, 0), value(1, 0), tx), glm::mix(value(0, 1), value(1, 1), tx), ty);
}

std::uint8_t eight_bits(double value) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

double srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

// Calls colour(x, y) for every texel: a value of 0..1 for each of three channels.
template <typename Colour>
Texture filled(int size, const Colour& colour) {
  Texture texture{size, size, {}};
  texture.rgba.reserve(static_cast<std::size_t>(size) * size * 4);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const glm::dvec3 value = colour(x, y);
      for (int channel = 0; channel < 3; ++channel) texture.rgba.push_back(eight_bits(value[channel]));
      texture.rgba.push_back(255);
    }
  }
  return texture;
}

}  // namespace

double Relief::at(int x, int y) const {
  const auto wrapped = [this](int i) { return static_cast<std::size_t>((i % size + size) % size); };
  return heights[wrapped(y) * static_cast<std::size_t>(size) + wrapped(x)];
}

Relief fractal_relief(int size, const Grain& grain) {
  Relief relief{size, {}};
  relief.heights.reserve(static_cast<std::size_t>(size) * size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      double sum = 0.0, weight = 1.0;
      for (int octave = 0; octave < grain.octaves; ++octave, weight *= grain.persistence) {
        sum += weight * noise((x + 0.5) / size, (y + 0.5) / size, grain.cells_x << octave,
                              grain.cells_y << octave, grain.seed + static_cast<std::uint32_t>(octave));
      }
      relief.heights.push_back(sum);
    }
  }
  const auto [low, high] = std::minmax_element(relief.heights.begin(), relief.heights.end());
  const double lowest = *low, range = *high - *low;
  for (double& height : relief.heights) height = (height - lowest) / range;
  return relief;
}

Texture tinted(const Relief& relief, const glm::vec3& dark, const glm::vec3& light) {
  return filled(relief.size, [&](int x, int y) {
    const glm::dvec3 linear = glm::mix(glm::dvec3(dark), glm::dvec3(light), relief.at(x, y));
    return glm::dvec3(srgb(linear.x), srgb(linear.y), srgb(linear.z));
  });
}

Texture normals_of(const Relief& relief, double slope) {
  const double rise = 0.5 * slope * relief.size;  // a difference spans two texels
  return filled(relief.size, [&](int x, int y) {
    // Rows run down, while +Y points up.
    const glm::dvec3 normal(rise * (relief.at(x - 1, y) - relief.at(x + 1, y)),
                            rise * (relief.at(x, y + 1) - relief.at(x, y - 1)), 1.0);
    return 0.5 + 0.5 * glm::normalize(normal);
  });
}

}  // namespace penumbra::scene
