#include "bake/height_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "input/input_error.h"

namespace penumbra::bake {
namespace {

// A value that is not a number is neither a place nor a height.
bool is_place(double metres) {
  return std::abs(metres) <= most_ground_metres;
}
bool is_side(double metres) {
  return metres >= least_area_metres && metres <= most_ground_metres;
}

void check_side(int samples) {
  if (samples >= 2 && samples <= most_samples_per_side) return;
  throw InputError("", fmt::format("a height field has from 2 to {} samples per side, not {}",
                                   most_samples_per_side, samples));
}

}  // namespace

double HeightField::height(glm::dvec2 xz) const {
  const glm::dvec2 last(width - 1, depth - 1);
  const glm::dvec2 place = glm::clamp(in_samples(xz), glm::dvec2(0.0), last);
  const glm::dvec2 cell = glm::min(glm::floor(place), last - 1.0);
  const glm::dvec2 share = place - cell;
  const int x = static_cast<int>(cell.x);
  const int z = static_cast<int>(cell.y);
  const double first = std::lerp(double{at(x, z)}, double{at(x + 1, z)}, share.x);
  const double second = std::lerp(double{at(x, z + 1)}, double{at(x + 1, z + 1)}, share.x);
  return std::lerp(first, second, share.y);
}

void check_grid(int width, int depth, const Area& area) {
  check_side(width);
  check_side(depth);
  if (is_place(area.corner.x) && is_place(area.corner.y) && is_side(area.size.x) && is_side(area.size.y))
    return;
  throw InputError("",
                   fmt::format("a height field cannot cover {} x {} metres from x {}, z {}: its corner lies "
                               "within {} metres of the origin, and its sides are from {} to {} metres",
                               area.size.x, area.size.y, area.corner.x, area.corner.y, most_ground_metres,
                               least_area_metres, most_ground_metres),
                   "give another area: X,Z,WIDTH,DEPTH in metres, such as --area 0,0,1000,1000");
}

void check_height_field(const HeightField& field) {
  check_grid(field.width, field.depth, field.area);
  if (field.metres.size() != static_cast<std::size_t>(field.width) * static_cast<std::size_t>(field.depth)) {
    throw InputError("", fmt::format("a height field of {} x {} samples cannot have {} heights", field.width,
                                     field.depth, field.metres.size()));
  }
  const auto unusable = std::find_if_not(field.metres.begin(), field.metres.end(),
                                         [](float metres) { return std::isfinite(metres); });
  if (unusable != field.metres.end()) {
    const auto index = unusable - field.metres.begin();
    throw InputError("", fmt::format("the height at column {}, row {} is not a finite number",
                                     index % field.width, index / field.width));
  }
}

}  // namespace penumbra::bake
