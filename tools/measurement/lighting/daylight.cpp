#include "lighting/daylight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

namespace penumbra::lighting {
namespace {

constexpr double kSunKilolux = 133.0;                  // above the air
constexpr glm::dvec3 kSunColour{1.075, 0.985, 0.945};  // a body of 5778 K, with Y = 1
constexpr glm::dvec3 kMicrometres{0.612, 0.549,
                                  0.465};  // wavelengths at which the three channels are evaluated
constexpr double kGroundReflectance = 0.2;
constexpr double kHorizonFade = 0.12;  // sine of the depression by which 1 - 1/e of the ground shows

using Cubic =
    std::array<double, 4>;  // coefficients of the sun's zenith angle cubed, squared, linear, constant

double at(const Cubic& cubic, double angle) {
  return ((cubic[0] * angle + cubic[1]) * angle + cubic[2]) * angle + cubic[3];
}

double zenith_chromaticity(const std::array<Cubic, 3>& by_turbidity, double t, double sun_zenith) {
  return t * t * at(by_turbidity[0], sun_zenith) + t * at(by_turbidity[1], sun_zenith) +
         at(by_turbidity[2], sun_zenith);
}

glm::dvec3 zenith_xyY(double t, double sun_zenith) {
  static constexpr std::array<Cubic, 3> kX{{{0.00166, -0.00375, 0.00209, 0.0},
                                            {-0.02903, 0.06377, -0.03202, 0.00394},
                                            {0.11693, -0.21196, 0.06052, 0.25886}}};
  static constexpr std::array<Cubic, 3> kY{{{0.00275, -0.00610, 0.00317, 0.0},
                                            {-0.04214, 0.08970, -0.04153, 0.00516},
                                            {0.15346, -0.26756, 0.06670, 0.26688}}};
  const double chi = (4.0 / 9.0 - t / 120.0) * (std::numbers::pi - 2.0 * sun_zenith);
  const double luminance = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
  return {zenith_chromaticity(kX, t, sun_zenith), zenith_chromaticity(kY, t, sun_zenith), luminance};
}

glm::dvec3 rec709_of_xyY(const glm::dvec3& xyY) {
  const double luminance = xyY.z;
  const glm::dvec3 xyz{xyY.x / xyY.y * luminance, luminance, (1.0 - xyY.x - xyY.y) / xyY.y * luminance};
  return {3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
          0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z};
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

double zenith_angle(const glm::dvec3& direction) {
  return std::min(angle_between(direction, {0.0, 1.0, 0.0}), std::numbers::pi / 2.0);
}

glm::dvec3 sun_through_air(double zenith, double turbidity) {
  const double degrees = zenith * 180.0 / std::numbers::pi;
  const double mass =
      1.0 / (std::cos(zenith) + 0.15 * std::pow(93.885 - degrees, -1.253));  // relative mass of air
  const double haze = 0.04608 * turbidity - 0.04586;
  glm::dvec3 light = kSunKilolux * kSunColour;
  for (int channel = 0; channel < 3; ++channel) {
    const double rayleigh = 0.008735 * std::pow(kMicrometres[channel], -4.08);
    const double aerosol = haze * std::pow(kMicrometres[channel], -1.3);
    light[channel] *= std::exp(-(rayleigh + aerosol) * mass);
  }
  return light;
}

}  // namespace

double Daylight::Perez::at(double cos_zenith, double gamma) const {
  const double cos_gamma = std::cos(gamma);
  return (1.0 + a * std::exp(b / cos_zenith)) * (1.0 + c * std::exp(d * gamma) + e * cos_gamma * cos_gamma);
}

Daylight::Daylight(const glm::dvec3& to_sun, double turbidity)
    : to_sun_(to_sun), sun_(sun_through_air(zenith_angle(to_sun), turbidity)) {
  const double t = turbidity;
  perez_[0] = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
               -0.0033 * t + 0.0452};
  perez_[1] = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
               -0.0109 * t + 0.0529};
  perez_[2] = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
               -0.0670 * t + 0.3703};
  const double sun_zenith = zenith_angle(to_sun);
  const glm::dvec3 zenith = zenith_xyY(t, sun_zenith);
  for (int i = 0; i < 3; ++i) scale_[i] = zenith[i] / perez_[i].at(1.0, sun_zenith);
  const glm::dvec3 light = level_irradiance() + std::max(to_sun.y, 0.0) * sun_;
  ground_ = light * (kGroundReflectance / std::numbers::pi);
}

glm::dvec3 Daylight::above_horizon(const glm::dvec3& direction) const {
  const double cos_zenith = std::max(direction.y, 0.005);  // the formula has a pole at the horizon
  const double gamma = angle_between(direction, to_sun_);
  glm::dvec3 xyY;
  for (int i = 0; i < 3; ++i) xyY[i] = scale_[i] * perez_[i].at(cos_zenith, gamma);
  return glm::max(rec709_of_xyY(xyY), glm::dvec3(0.0));
}

// The integral uses the midpoint rule over rings of equal cosine-weighted area.
glm::dvec3 Daylight::level_irradiance() const {
  constexpr int kRings = 8;
  constexpr int kSectors = 16;
  glm::dvec3 sum(0.0);
  for (int ring = 0; ring < kRings; ++ring) {
    const double sine = std::sqrt((ring + 0.5) / kRings);
    for (int sector = 0; sector < kSectors; ++sector) {
      const double angle = 2.0 * std::numbers::pi * (sector + 0.5) / kSectors;
      sum += above_horizon({sine * std::cos(angle), std::sqrt(1.0 - sine * sine), sine * std::sin(angle)});
    }
  }
  return sum * (std::numbers::pi / (kRings * kSectors));
}

glm::dvec3 Daylight::sky(const glm::dvec3& direction) const {
  const glm::dvec3 sky = above_horizon(direction);
  return direction.y >= 0.0 ? sky : glm::mix(ground_, sky, std::exp(direction.y / kHorizonFade));
}

}  // namespace penumbra::lighting
