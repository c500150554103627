#include "bake/horizon_angles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

#include "bake/horizon_search.h"
#include "input/input_error.h"
#include "platform/content_hash.h"

namespace penumbra::bake {
namespace {

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
  platform::ContentHash hash;
  hash.update(std::string_view("horizon")).update(kHorizonVersion);
  hash.update(field.width).update(field.depth);
  for (const glm::dvec2& pair : {field.area.corner, field.area.size}) hash.update(pair.x).update(pair.y);
  hash.update(std::span<const float>(field.metres));
  hash.update(options.width).update(options.depth).update(options.nearest_metres);
  return hash.hex();
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
  const BakeJob job{key_of(field, options), static_cast<std::size_t>(options.depth), [&](std::size_t row) {
                      std::vector<float> radians;
                      for (int x = 0; x < options.width; ++x) {
                        const glm::dvec2 from = angles.centre(x, static_cast<int>(row));
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

}  // namespace penumbra::bake
