// The light of a clear day: a sun and the sky that belongs to it.
//
// Source: the sky is A. J. Preetham, P. Shirley, B. Smits, "A Practical Analytic Model for Daylight"
// (SIGGRAPH 1999), appendix A.2: luminance and chromaticity by Perez' five-parameter formula. The sun is a
// body of 5778 K of 133 klx above the air, dimmed at three wavelengths by the paper's Rayleigh and aerosol
// terms (appendix A.1; ozone, gas and water are left out: under 5 %). Units: linear Rec. 709 of white D65;
// radiance in kcd/m2, irradiance in klx (luminance is the colour's Y). Space: the scene's, +Y up. Directions
// are unit and point away from the surface.
#pragma once

#include <glm/vec3.hpp>

namespace penumbra::lighting {

class Daylight {
 public:
  // to_sun is a unit vector. turbidity is haze: 2 is very clear, 6 is hazy.
  explicit Daylight(const glm::dvec3& to_sun, double turbidity = 3.0);

  // Returns the radiance of the sky alone, without the sun's disc. Below the horizon it is that of a ground
  // of reflectance 0.2 under this light. Haze hides that ground towards the horizon, most of it within five
  // degrees.
  glm::dvec3 sky(const glm::dvec3& direction) const;

  const glm::dvec3& to_sun() const { return to_sun_; }
  const glm::dvec3& sun() const { return sun_; }  // irradiance of a surface that faces it

 private:
  // Perez' distribution: gradation towards the horizon, and scattering around the sun.
  struct Perez {
    double a, b, c, d, e;
    double at(double cos_zenith, double gamma) const;
  };

  glm::dvec3 above_horizon(const glm::dvec3& direction) const;
  glm::dvec3 level_irradiance() const;

  glm::dvec3 to_sun_;
  glm::dvec3 sun_;
  Perez perez_[3];    // for x, y and luminance
  glm::dvec3 scale_;  // factors that take each to its value at the zenith
  glm::dvec3 ground_{0.0};
};

}  // namespace penumbra::lighting
