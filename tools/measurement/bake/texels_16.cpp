#include "bake/texels_16.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penumbra::bake {

std::uint16_t as_16_bits(double share) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * 65535.0));
}

HeightRange range_of(const HeightField& field) {
  const auto [low, high] = std::minmax_element(field.metres.begin(), field.metres.end());
  return {static_cast<double>(*low), static_cast<double>(*high > *low ? *high : *low + 1.0F)};
}

std::vector<std::uint16_t> height_texels(const HeightField& field, const HeightRange& range) {
  std::vector<std::uint16_t> texels;
  texels.reserve(field.metres.size());
  for (const float metres : field.metres)
    texels.push_back(as_16_bits((static_cast<double>(metres) - range.low) / (range.high - range.low)));
  return texels;
}

std::vector<std::uint16_t> angle_texels(const HorizonAngles& angles, int first) {
  const std::size_t count = angles.radians[0].size();
  std::vector<std::uint16_t> texels;
  texels.reserve(horizon_channels * count);
  for (std::size_t i = 0; i < count; ++i)
    for (int channel = 0; channel < horizon_channels; ++channel)
      texels.push_back(
          as_16_bits(static_cast<double>(angles.radians[static_cast<std::size_t>(first + channel)][i]) /
                     (std::numbers::pi / 2.0)));
  return texels;
}

}  // namespace penumbra::bake
