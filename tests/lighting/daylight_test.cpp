#include "lighting/daylight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace penumbra::lighting {
namespace {

const glm::dvec3 kLuminance(0.2126, 0.7152, 0.0722);

glm::dvec3 at_elevation(double degrees, double azimuth = 0.0) {
  const double e = glm::radians(degrees);
  const double a = glm::radians(azimuth);
  return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

// The expected value is Preetham's zenith luminance (appendix A.2), worked out by hand for turbidity 3 and
// the sun 60 degrees from the zenith.
TEST(Daylight, TheZenithHasThePublishedLuminance) {
  const Daylight day(at_elevation(30.0), 3.0);
  const double chi = (4.0 / 9.0 - 3.0 / 120.0) * glm::radians(180.0 - 120.0);
  const double expected = (4.0453 * 3.0 - 4.9710) * std::tan(chi) - 0.2155 * 3.0 + 2.4192;
  EXPECT_NEAR(glm::dot(day.sky({0.0, 1.0, 0.0}), kLuminance), expected, 0.01 * expected);
}

TEST(Daylight, TheSkyIsBlueAndTheLowSunIsRed) {
  const Daylight noon(at_elevation(60.0));
  const glm::dvec3 opposite = noon.sky(at_elevation(45.0, 180.0));
  EXPECT_GT(opposite.b, 1.2 * opposite.r);
  EXPECT_GT(noon.sun().r, noon.sun().b);
  const Daylight evening(at_elevation(5.0));
  EXPECT_GT(evening.sun().r / evening.sun().b, 2.0 * noon.sun().r / noon.sun().b);
  EXPECT_LT(glm::dot(evening.sun(), kLuminance), 0.5 * glm::dot(noon.sun(), kLuminance));
}

// A meter reads on a clear day some 60 to 110 klx of sun, and a tenth to a third of it of sky.
TEST(Daylight, SunAndSkyAreInProportion) {
  const Daylight day(at_elevation(45.0));
  const double sun = glm::dot(day.sun(), kLuminance);
  EXPECT_GT(sun, 60.0);
  EXPECT_LT(sun, 110.0);
  double sky = 0.0;
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double sine = std::sqrt((i + 0.5) / kSteps);
      const double angle = glm::radians(360.0 * (j + 0.5) / kSteps);
      sky += glm::dot(day.sky({sine * std::cos(angle), std::sqrt(1.0 - sine * sine), sine * std::sin(angle)}),
                      kLuminance);
    }
  }
  sky *= glm::radians(180.0) / (kSteps * kSteps);
  EXPECT_GT(sky, 0.1 * sun);
  EXPECT_LT(sky, 0.34 * sun);
}

TEST(Daylight, EveryDirectionOfEverySunIsFiniteAndNoneIsNegative) {
  for (const double elevation : {0.0, 0.5, 10.0, 45.0, 89.9, 90.0}) {
    const Daylight day(at_elevation(elevation));
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_TRUE(std::isfinite(day.sun()[channel]) && day.sun()[channel] >= 0.0) << elevation;
    }
    for (double up = -90.0; up <= 90.0; up += 7.5) {
      for (double azimuth = 0.0; azimuth < 360.0; azimuth += 30.0) {
        const glm::dvec3 colour = day.sky(at_elevation(up, azimuth));
        for (int channel = 0; channel < 3; ++channel) {
          ASSERT_TRUE(std::isfinite(colour[channel]) && colour[channel] >= 0.0)
              << elevation << " " << up << " " << azimuth;
        }
      }
    }
  }
}

TEST(Daylight, TheGroundReflectsAFifthOfWhatFallsOnIt) {
  const Daylight day(at_elevation(45.0));
  const glm::dvec3 ground = day.sky({0.0, -1.0, 0.0});
  const double sun_alone =
      0.2 * glm::dot(day.sun(), kLuminance) * std::sin(glm::radians(45.0)) / glm::radians(180.0);
  EXPECT_GT(glm::dot(ground, kLuminance), sun_alone);
  EXPECT_LT(glm::dot(ground, kLuminance), 1.6 * sun_alone);
}

}  // namespace
}  // namespace penumbra::lighting
