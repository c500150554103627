#include "scene/clouds.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace penumbra::scene {
namespace {

std::uint32_t mixed(std::uint32_t bits) {
  bits = (bits ^ (bits >> 15U)) * 0x2C1B3C6DU;
  bits = (bits ^ (bits >> 12U)) * 0x297A2D39U;
  return bits ^ (bits >> 15U);
}

double corner_value(std::int64_t x, std::int64_t z, std::uint32_t octave) {
  const std::uint32_t bits = mixed(static_cast<std::uint32_t>(x) * 0x8DA6B343U ^
                                   static_cast<std::uint32_t>(z) * 0xD8163841U ^ octave * 0xCB1AB31FU);
  return (bits >> 8U) / 16777215.0;
}

// Returns the weights of a cell's lower and upper corner along one axis.
std::array<double, 2> faded(double t) {
  const double upper = std::pow(t, 3) * (10.0 - 15.0 * t + 6.0 * t * t);
  return {1.0 - upper, upper};
}

double octave_of_noise(const glm::dvec2& place, std::uint32_t octave) {
  const auto x = static_cast<std::int64_t>(std::floor(place.x));
  const auto z = static_cast<std::int64_t>(std::floor(place.y));
  const std::array<double, 2> across = faded(place.x - static_cast<double>(x));
  const std::array<double, 2> along = faded(place.y - static_cast<double>(z));
  double sum = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      sum += across[i] * along[j] *
             corner_value(x + static_cast<std::int64_t>(i), z + static_cast<std::int64_t>(j), octave);
  return sum;
}

}  // namespace

double cloud_transmittance(const CloudLayer& layer, const glm::dvec2& place) {
  if (!(layer.coverage > 0.0)) return 1.0;
  double noise = 0.0;
  for (std::uint32_t octave = 0; octave < 5; ++octave) {
    const double size = layer.feature_metres / static_cast<double>(1U << octave);
    noise += 16.0 / 31.0 / static_cast<double>(1U << octave) * octave_of_noise(place / size, octave + 1);
  }
  const double above = noise - (1.0 - layer.coverage);
  return above <= 0.0 ? 1.0 : std::exp(-layer.density * above / layer.coverage);
}

}  // namespace penumbra::scene
