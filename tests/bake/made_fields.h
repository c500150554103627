// Height fields that tests use.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "bake/height_field.h"

namespace penumbra::bake {

template <typename Height>
HeightField made_field(int width, int depth, Area area, const Height& height) {
  HeightField field{width, depth, area, {}};
  for (int z = 0; z < depth; ++z) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec2 place = area.corner + field.spacing() * glm::dvec2(x, z);
      field.metres.push_back(static_cast<float>(height(place)));
    }
  }
  return field;
}

// Hills with noise on them, so that neighbouring cells differ in slope.
inline HeightField rough_field(int width, int depth, Area area, std::uint32_t seed) {
  std::mt19937 bits(seed);
  const auto chance = [&] { return static_cast<double>(bits()) * 0x1p-32; };
  const double phase = 6.0 * chance();
  const double length = 0.1 * (area.size.x + area.size.y) * (0.5 + chance());
  return made_field(width, depth, area, [&](glm::dvec2 at) {
    return 0.2 * length * std::sin(at.x / length + phase) * std::cos(at.y / length) +
           0.05 * length * chance();
  });
}

}  // namespace penumbra::bake
