// Textures made by arithmetic, which repeat without a seam: grain, blotches and the relief of both.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/material.h"

namespace penumbra::scene {

// Heights in 0..1, square, rows from the top.
struct Relief {
  int size;
  std::vector<double> heights;

  // Coordinates outside repeat.
  double at(int x, int y) const;
};

// A sum of value noises (Perlin and Hoffert 1989, fractal noise): octave k has cells_x * 2^k by
// cells_y * 2^k cells and `persistence` of the height of the octave before. More cells one way than the other
// give streaks.
struct Grain {
  int cells_x = 4;
  int cells_y = 4;
  int octaves = 5;
  double persistence = 0.5;
  std::uint32_t seed = 1;
};
Relief fractal_relief(int size, const Grain& grain);

// Returns a texture with colours between `dark` (height 0) and `light` (height 1), linear Rec. 709; the
// texture holds them as sRGB.
Texture tinted(const Relief& relief, const glm::vec3& dark, const glm::vec3& light);

// Returns the normals of the relief in tangent space, +Y up. `slope` is the rise of a full height over one
// texture's edge.
Texture normals_of(const Relief& relief, double slope);

}  // namespace penumbra::scene
