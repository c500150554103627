#include "bake/horizon_angles.h"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "input/input_error.h"
#include "platform/hashed_fields.h"

namespace penumbra::bake {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kStepInside = 1e-7;   // cells: past a cell's edge, so that the next cell is found
constexpr double kLeastAside = 1e-10;  // relative to a direction's larger component
constexpr double kShortest = 1e-6;     // metres: slopes are those to points at least so far away

// A part of the ray, by its distances in metres.
struct Stretch {
  double begin = 0.0;
  double end = 0.0;
};

// A ray over the grid, in samples from the first one: where + along * metres.
struct GridRay {
  glm::dvec2 where{0.0};
  glm::dvec2 along{0.0};

  // A direction that is almost an axis becomes that axis: otherwise a ray along an edge of cells could be
  // said to leave a cell that it does not enter within rounding.
  GridRay(glm::dvec2 from, glm::dvec2 samples_per_metre) : where(from), along(samples_per_metre) {
    const double least = kLeastAside * std::max(std::abs(along.x), std::abs(along.y));
    for (int axis = 0; axis < 2; ++axis)
      if (std::abs(along[axis]) < least) along[axis] = 0.0;
  }

  glm::dvec2 at(double metres) const { return where + along * metres; }

  // The part of the ray before `limit` in which it is within these bounds, which may be none.
  Stretch within(glm::dvec2 low, glm::dvec2 high, Stretch limit) const {
    for (int axis = 0; axis < 2; ++axis) {
      if (along[axis] == 0.0) {
        if (where[axis] < low[axis] || where[axis] > high[axis]) return {0.0, -1.0};
        continue;
      }
      const double a = (low[axis] - where[axis]) / along[axis];
      const double b = (high[axis] - where[axis]) / along[axis];
      limit.begin = std::max(limit.begin, std::min(a, b));
      limit.end = std::min(limit.end, std::max(a, b));
    }
    return limit;
  }
};

// Returns an upper bound of the slope: ground that lies higher is divided by the least distance, ground that
// lies lower by the largest.
double slope_bound(double rise, Stretch stretch) {
  if (rise <= 0.0) return rise / stretch.end;
  return stretch.begin > 0.0 ? rise / stretch.begin : kInfinity;
}

// The surface over a cell along the ray: a + b t + c t^2, t in metres from the ray's origin.
double steepest_over_cell(const HeightField& field, const GridRay& ray, int x, int z, double height,
                          Stretch stretch) {
  const double corner = field.at(x, z);
  const double by_x = field.at(x + 1, z) - corner;
  const double by_z = field.at(x, z + 1) - corner;
  const double by_both = field.at(x + 1, z + 1) - field.at(x + 1, z) - by_z;
  const glm::dvec2 from = ray.where - glm::dvec2(x, z);
  const double a = corner + by_x * from.x + by_z * from.y + by_both * from.x * from.y - height;
  const double b =
      by_x * ray.along.x + by_z * ray.along.y + by_both * (from.x * ray.along.y + from.y * ray.along.x);
  const double c = by_both * ray.along.x * ray.along.y;
  const auto slope = [&](double t) { return a / t + b + c * t; };
  const double begin = std::max(stretch.begin, kShortest);
  const double end = std::max(stretch.end, begin);
  double steepest = std::max(slope(begin), slope(end));
  if (a < 0.0 && c < 0.0) {  // the slope has a maximum, at sqrt(a / c)
    steepest = std::max(steepest, slope(std::clamp(std::sqrt(a / c), begin, end)));
  }
  return steepest;
}

constexpr int kHorizonVersion = 1;  // increased whenever a change affects any result

void check(const HorizonOptions& options) {
  for (const int side : {options.width, options.depth}) {
    if (side >= 1 && side <= most_horizon_texels_per_side) continue;
    throw InputError("", fmt::format("horizon angles have from 1 to {} texels per side, not {}",
                                     most_horizon_texels_per_side, side));
  }
  if (!std::isfinite(options.nearest_metres) || options.nearest_metres < 0.0) {
    throw InputError("", fmt::format("ground cannot begin to count at {} metres", options.nearest_metres));
  }
}

std::string key_of(const HeightField& field, const HorizonOptions& options) {
  return platform::hash_of("horizon", kHorizonVersion, field, options);
}

}  // namespace

glm::dvec2 horizon_direction(int number) {
  const double azimuth = number * std::numbers::pi / 4.0;
  return {std::sin(azimuth), std::cos(azimuth)};
}

glm::dvec2 HorizonAngles::centre(int x, int z) const {
  return area.corner + area.size * (glm::dvec2(x, z) + 0.5) / glm::dvec2(width, depth);
}

HorizonAngles bake_horizon_angles(const HeightField& field, const HorizonOptions& options,
                                  const BakeOptions& run) {
  check_height_field(field);
  check(options);
  HorizonAngles angles{options.width, options.depth, field.area, {}};
  const HorizonSearch search(field);
  // Each block is a row: for each texel its eight angles.
  const BakeJob job{key_of(field, options), options.depth, [&](int row) {
                      std::vector<float> radians;
                      for (int x = 0; x < options.width; ++x) {
                        const glm::dvec2 from = angles.centre(x, row);
                        const double height = field.height(from);
                        for (int number = 0; number < horizon_directions; ++number) {
                          const double slope = search.steepest(from, height, horizon_direction(number),
                                                               options.nearest_metres);
                          radians.push_back(static_cast<float>(std::atan(std::max(slope, 0.0))));
                        }
                      }
                      return radians;
                    }};
  const std::vector<float> numbers = run_bake(job, run);
  for (std::vector<float>& channel : angles.radians) channel.reserve(numbers.size() / horizon_directions);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    angles.radians[i % horizon_directions].push_back(numbers[i]);
  return angles;
}

HorizonSearch::HorizonSearch(const HeightField& field) : field_(field) {
  Level cells{field.width - 1, field.depth - 1, {}};
  cells.highest.reserve(static_cast<std::size_t>(cells.width) * cells.depth);
  for (int z = 0; z < cells.depth; ++z) {
    for (int x = 0; x < cells.width; ++x) {
      cells.highest.push_back(
          std::max({field.at(x, z), field.at(x + 1, z), field.at(x, z + 1), field.at(x + 1, z + 1)}));
    }
  }
  levels_.push_back(std::move(cells));
  while (levels_.back().width > 1 || levels_.back().depth > 1) {
    const Level& below = levels_.back();
    Level level{(below.width + 1) / 2, (below.depth + 1) / 2, {}};
    level.highest.assign(static_cast<std::size_t>(level.width) * level.depth,
                         -std::numeric_limits<float>::infinity());
    for (int z = 0; z < below.depth; ++z) {
      for (int x = 0; x < below.width; ++x) {
        float& highest = level.highest[static_cast<std::size_t>(z / 2) * level.width + x / 2];
        highest = std::max(highest, below.highest[static_cast<std::size_t>(z) * below.width + x]);
      }
    }
    levels_.push_back(std::move(level));
  }
}

double HorizonSearch::steepest(glm::dvec2 from, double height, glm::dvec2 direction,
                               double nearest_metres) const {
  const GridRay ray(field_.in_samples(from), direction / field_.spacing());
  const glm::ivec2 cells(field_.width - 1, field_.depth - 1);
  const Stretch field =
      ray.within(glm::dvec2(0.0), glm::dvec2(cells), {std::max(nearest_metres, 0.0), kInfinity});
  double steepest = -kInfinity;
  if (!(field.begin <= field.end)) return steepest;
  const double step_inside = kStepInside / std::max(std::abs(ray.along.x), std::abs(ray.along.y));
  const int top = static_cast<int>(levels_.size()) - 1;
  int level = 0;
  for (double t = field.begin; t <= field.end;) {
    const glm::dvec2 inside = glm::floor(ray.at(t + step_inside));
    const glm::ivec2 cell = glm::clamp(glm::ivec2(inside), glm::ivec2(0), cells - 1);
    const glm::ivec2 block(cell.x >> level, cell.y >> level);
    const glm::dvec2 low(block.x << level, block.y << level);
    const Stretch within = ray.within(low, low + double(1 << level), {t, field.end});
    const double end = std::max(within.end, t);
    const double highest =
        levels_[level].highest[static_cast<std::size_t>(block.y) * levels_[level].width + block.x];
    if (slope_bound(highest - height, {t, std::max(end, kShortest)}) > steepest) {
      if (level > 0) {
        --level;
        continue;
      }
      steepest = std::max(steepest, steepest_over_cell(field_, ray, cell.x, cell.y, height, {t, end}));
    }
    t = std::max(end, t + step_inside);
    level = std::min(level + 1, top);
  }
  return steepest;
}

}  // namespace penumbra::bake
