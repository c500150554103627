// Tells how far apart two colours look to people with each kind of colour vision.
//
// Source: simulation by the matrices of G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A
// Physiologically-based Model for Simulation of Color Vision Deficiency" (IEEE TVCG 2009), severity 1, on
// linear Rec. 709; differences by CIE 1976 (CIELAB, D65): 1 is just noticeable side by side, 10 is plain at a
// glance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace penumbra::colour_vision {

// The rows are as the paper prints them: normal vision, protanopia, deuteranopia, tritanopia.
inline const std::array<glm::dmat3, 4> kKinds{
    glm::dmat3(1.0),
    glm::transpose(glm::dmat3(0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882,
                              -0.048116, 1.051998)),
    glm::transpose(glm::dmat3(0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820,
                              0.042940, 0.968881)),
    glm::transpose(glm::dmat3(1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733,
                              0.691367, 0.303900))};

// The CIELAB of an sRGB colour (channels 0 .. 1) as seen with one kind of vision; x is lightness, 0 .. 100.
inline glm::dvec3 seen(const glm::dvec3& srgb, const glm::dmat3& kind) {
  glm::dvec3 linear;
  for (int i = 0; i < 3; ++i) {
    linear[i] = srgb[i] <= 0.04045 ? srgb[i] / 12.92 : std::pow((srgb[i] + 0.055) / 1.055, 2.4);
  }
  linear = glm::clamp(kind * linear, 0.0, 1.0);
  const auto response = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const double x = response((0.4124 * linear.r + 0.3576 * linear.g + 0.1805 * linear.b) / 0.9505);
  const double y = response(0.2126 * linear.r + 0.7152 * linear.g + 0.0722 * linear.b);
  const double z = response((0.0193 * linear.r + 0.1192 * linear.g + 0.9505 * linear.b) / 1.089);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

// The smallest difference over all kinds.
inline double least_difference(const glm::dvec3& a, const glm::dvec3& b) {
  double least = 1e9;
  for (const glm::dmat3& kind : kKinds) least = std::min(least, glm::distance(seen(a, kind), seen(b, kind)));
  return least;
}

}  // namespace penumbra::colour_vision
