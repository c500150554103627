// The ground as heights on a grid, bilinear in between. Far shadows are baked from it.
//
// Heights are in metres. The grid's axes are those of the world, relative to the scene's origin. Unity's
// terrains have the same layout: samples lie at the corners of cells, the first at the terrain's own corner
// and the last at the opposite one; rows run along +X, and the first row has the smallest z.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace penumbra::bake {

// A field has at least two samples each way, and at most so many.
inline constexpr int most_samples_per_side = 8193;  // a power of two and one, as Unity's terrains have

// The largest distance in metres of an area or a height from the origin, and the largest length of an area's
// sides.
inline constexpr double most_ground_metres = 1e6;
inline constexpr double least_area_metres = 1e-6;

// The rectangle that a grid covers: metres in x and z, relative to the scene's origin.
struct Area {
  glm::dvec2 corner{0.0};  // the smallest x and z
  glm::dvec2 size{0.0};    // positive

  bool operator==(const Area&) const = default;
};

struct HeightField {
  int width = 0;  // samples along x
  int depth = 0;  // samples along z
  Area area;
  std::vector<float> metres;  // width * depth
  std::size_t holes = 0;      // samples where the source has no surface

  float at(int x, int z) const { return metres[static_cast<std::size_t>(z) * width + x]; }
  // Returns the metres between neighbours along x and z.
  glm::dvec2 spacing() const { return area.size / glm::dvec2(width - 1, depth - 1); }
  // Returns the place of a point of the world in samples from the first one, not clamped.
  glm::dvec2 in_samples(glm::dvec2 xz) const { return (xz - area.corner) / spacing(); }
  // Returns the bilinear height; outside of the area, that of the nearest point inside.
  double height(glm::dvec2 xz) const;
};

// Throws InputError unless there are two samples each way or more, no more than most_samples_per_side, and an
// area within most_ground_metres of the origin whose sides are from least_area_metres to most_ground_metres.
void check_grid(int width, int depth, const Area& area);

// Throws InputError unless the field has two samples each way or more, no more than most_samples_per_side,
// as many heights as samples, all of them finite, and an area as check_grid() has it.
void check_height_field(const HeightField& field);

}  // namespace penumbra::bake
