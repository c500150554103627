#include "study/colour_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace penumbra::study {
namespace {

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

// colour(pixel index) for every pixel that has a receiver.
template <typename Colour>
Picture paint(const PixelGrid& grid, std::size_t values, const Colour& colour) {
  const std::size_t size = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
  if (grid.valid.size() != size || values != size) {
    throw std::invalid_argument("the images of a picture differ in size");
  }
  Picture picture = filled_picture(grid.width, grid.height, kNoReceiver);
  for (std::size_t i = 0; i < size; ++i) {
    if (grid.valid[i] == 0) continue;
    const auto width = static_cast<std::size_t>(grid.width);
    set_pixel(picture, static_cast<int>(i % width), static_cast<int>(i / width), colour(i));
  }
  return picture;
}

}  // namespace

Rgb visibility_colour(double visibility) {
  const std::uint8_t grey = to_byte(visibility);
  return {grey, grey, grey};
}

Rgb error_colour(double share) {
  constexpr double kBlue[] = {0.10, 0.35, 0.85};
  constexpr double kRed[] = {0.85, 0.20, 0.15};
  const double amount = std::min(std::abs(share), 1.0);
  const double* end = share < 0.0 ? kBlue : kRed;
  return {to_byte(std::lerp(1.0, end[0], amount)), to_byte(std::lerp(1.0, end[1], amount)),
          to_byte(std::lerp(1.0, end[2], amount))};
}

Rgb fetch_colour(double share) {
  constexpr double kStart = 0.5;
  constexpr double kRotations = -1.5;
  const double value = std::clamp(share, 0.0, 1.0);
  const double angle = 2.0 * std::numbers::pi * (kStart / 3.0 + kRotations * value);
  const double amplitude = value * (1.0 - value) / 2.0;
  const double c = amplitude * std::cos(angle);
  const double s = amplitude * std::sin(angle);
  return {to_byte(value - 0.14861 * c + 1.78277 * s), to_byte(value - 0.29227 * c - 0.90649 * s),
          to_byte(value + 1.97294 * c)};
}

Picture visibility_picture(const PixelGrid& grid, std::span<const float> visibility) {
  return paint(grid, visibility.size(), [&](std::size_t i) {
    const float value = visibility[i];
    return value >= 0.0F && value <= 1.0F ? visibility_colour(value) : kInvalid;
  });
}

Picture error_picture(const PixelGrid& grid, std::span<const float> result, std::span<const float> reference,
                      double full_scale) {
  if (result.size() != reference.size()) {
    throw std::invalid_argument("the images of a picture differ in size");
  }
  return paint(grid, result.size(), [&](std::size_t i) {
    const double error = static_cast<double>(result[i]) - static_cast<double>(reference[i]);
    return std::isfinite(error) ? error_colour(error / full_scale) : kInvalid;
  });
}

Picture fetch_picture(const PixelGrid& grid, std::span<const std::uint32_t> fetches, double full_scale) {
  return paint(grid, fetches.size(), [&](std::size_t i) { return fetch_colour(fetches[i] / full_scale); });
}

Picture count_picture(const PixelGrid& grid, std::span<const std::uint32_t> counts) {
  if (grid.valid.size() != counts.size())
    throw std::invalid_argument("the images of a picture differ in size");
  Picture picture{grid.width, grid.height, 1, {}};
  picture.samples.reserve(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::uint32_t count = grid.valid[i] == 0 ? 0U : std::min(counts[i], 255U);
    picture.samples.push_back(static_cast<std::uint8_t>(count));
  }
  return picture;
}

Picture colour_picture(int width, int height, std::span<const glm::vec3> colours) {
  if (colours.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    throw std::invalid_argument("the colours are not those of a picture of this size");
  }
  Picture picture = filled_picture(width, height, {});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec3& colour = colours[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                        static_cast<std::size_t>(x)];
      set_pixel(picture, x, y, {to_byte(colour.r), to_byte(colour.g), to_byte(colour.b)});
    }
  }
  return picture;
}

Picture ramp_strip(Rgb (*ramp)(double), double from, double to) {
  constexpr int kWidth = 256;
  Picture strip = filled_picture(kWidth, 1, {});
  for (int x = 0; x < kWidth; ++x) set_pixel(strip, x, 0, ramp(std::lerp(from, to, x / (kWidth - 1.0))));
  return strip;
}

}  // namespace penumbra::study
