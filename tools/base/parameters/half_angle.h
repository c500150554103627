// The tangent of half an angle: the radius of a light's disc, or half a picture's height, at distance 1.
#pragma once

#include <cmath>
#include <numbers>

namespace penumbra::parameters {

// `degrees` is the full angle, from one side to the other.
template <typename Real = double>
Real tan_half(Real degrees) {
  return std::tan(degrees * std::numbers::pi_v<Real> / 360);
}

}  // namespace penumbra::parameters
