#include "study/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace penumbra::study {
namespace {

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

// Calls colour(pixel index) for every pixel that has a receiver.
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
  constexpr double kBlue[] = {0.10, 0.40, 0.84};
  constexpr double kVermilion[] = {0.82, 0.27, 0.02};
  const double amount = std::min(std::abs(share), 1.0);
  const double* end = share < 0.0 ? kBlue : kVermilion;
  return {to_byte(std::lerp(1.0, end[0], amount)), to_byte(std::lerp(1.0, end[1], amount)),
          to_byte(std::lerp(1.0, end[2], amount))};
}

Rgb fetch_colour(double share) {
  static constexpr std::array<Rgb, 10> kCividis{{{0x00, 0x20, 0x4D},
                                                 {0x00, 0x33, 0x6F},
                                                 {0x39, 0x48, 0x6B},
                                                 {0x57, 0x5C, 0x6D},
                                                 {0x70, 0x71, 0x73},
                                                 {0x8A, 0x87, 0x79},
                                                 {0xA6, 0x9D, 0x75},
                                                 {0xC4, 0xB5, 0x6C},
                                                 {0xE4, 0xCF, 0x5B},
                                                 {0xFF, 0xEA, 0x46}}};
  const double place = std::clamp(share, 0.0, 1.0) * (kCividis.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), kCividis.size() - 2);
  const auto between = [&](std::uint8_t from, std::uint8_t to) {
    return to_byte(std::lerp(from / 255.0, to / 255.0, place - static_cast<double>(low)));
  };
  const Rgb& from = kCividis[low];
  const Rgb& to = kCividis[low + 1];
  return {between(from.r, to.r), between(from.g, to.g), between(from.b, to.b)};
}

Rgb category_colour(Category category) {
  switch (category) {
    case Category::orange:
      return {230, 159, 0};
    case Category::sky_blue:
      return {86, 180, 233};
    case Category::bluish_green:
      return {0, 158, 115};
    case Category::yellow:
      return {240, 228, 66};
    case Category::blue:
      return {0, 114, 178};
    case Category::vermillion:
      return {213, 94, 0};
    case Category::reddish_purple:
      break;
  }
  return {204, 121, 167};
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
