#include "bake/horizon_angles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bake/made_fields.h"
#include "input/input_error.h"

namespace penumbra::bake {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

BakeOptions with_jobs(int jobs) {
  BakeOptions options;
  options.jobs = jobs;
  return options;
}

// A cone of 10 m stands on level ground and is seen from far outside: in its direction the horizon is its
// top.
TEST(HorizonAngles, OfAConeAreThoseOfItsTop) {
  const auto cone = [](glm::dvec2 at) { return std::max(10.0 - std::hypot(at.x, at.y), 0.0); };
  const HeightField field = made_field(401, 401, {{-100.0, -100.0}, {200.0, 200.0}}, cone);
  const HorizonAngles angles = bake_horizon_angles(field, {.width = 40, .depth = 20});
  ASSERT_EQ(angles.radians[0].size(), 800U);
  int compared = 0;
  for (int z = 0; z < angles.depth; ++z) {
    for (int x = 0; x < angles.width; ++x) {
      const glm::dvec2 at = angles.centre(x, z);
      const double distance = std::hypot(at.x, at.y);
      if (distance < 12.0) continue;
      for (int number = 0; number < horizon_directions; ++number) {
        const glm::dvec2 direction = horizon_direction(number);
        const double along = -(at.x * direction.x + at.y * direction.y);
        const double aside = std::abs(at.x * direction.y - at.y * direction.x);
        const float radians = angles.radians[number][static_cast<std::size_t>(z) * angles.width + x];
        if (along < 0.0 || aside > 11.0) {
          EXPECT_EQ(radians, 0.0F);
        } else if (aside < 9.0) {
          // In the plane of the ray the cone is a hyperbola, 10 - sqrt(aside^2 + s^2). A search finds its
          // steepest tangent line from the ground.
          double slope = 0.0;
          for (double s = -10.0; s <= 10.0; s += 1e-3) {
            slope = std::max(slope, (10.0 - std::hypot(aside, s)) / (along + s));
          }
          EXPECT_NEAR(radians, std::atan(slope), 0.004) << x << ", " << z << ": " << number;
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 300);
}

TEST(HorizonAngles, DoNotDependOnTheNumberOfThreads) {
  const HeightField field = rough_field(65, 33, {{0.0, 0.0}, {64.0, 64.0}}, 3);
  const HorizonAngles one = bake_horizon_angles(field, {.width = 16, .depth = 24}, with_jobs(1));
  const HorizonAngles more = bake_horizon_angles(field, {.width = 16, .depth = 24}, with_jobs(3));
  EXPECT_EQ(one.radians, more.radians);
}

// Ground that begins to count at 30 m hides less than all of it.
TEST(HorizonAngles, LeaveOutWhatIsNear) {
  const HeightField field = rough_field(65, 65, {{0.0, 0.0}, {64.0, 64.0}}, 4);
  const HorizonAngles all = bake_horizon_angles(field, {.width = 8, .depth = 8});
  const HorizonAngles far_ones = bake_horizon_angles(field, {.width = 8, .depth = 8, .nearest_metres = 30.0});
  int lower = 0;
  for (int number = 0; number < horizon_directions; ++number) {
    for (std::size_t i = 0; i < all.radians[number].size(); ++i) {
      EXPECT_LE(far_ones.radians[number][i], all.radians[number][i]);
      if (far_ones.radians[number][i] < all.radians[number][i]) ++lower;
    }
  }
  EXPECT_GT(lower, 256);
}

TEST(HorizonAngles, RefuseUnusableOptions) {
  const HeightField field = rough_field(5, 5, {{0.0, 0.0}, {4.0, 4.0}}, 5);
  EXPECT_THAT([&] { bake_horizon_angles(field, {.width = 0}); },
              ThrowsMessage<InputError>(HasSubstr("from 1 to 8192 texels per side, not 0")));
  EXPECT_THAT([&] { bake_horizon_angles(field, {.depth = 16384}); },
              ThrowsMessage<InputError>(HasSubstr("not 16384")));
  EXPECT_THAT([&] { bake_horizon_angles(field, {.nearest_metres = -1.0}); },
              ThrowsMessage<InputError>(HasSubstr("cannot begin to count at -1 metres")));
}

}  // namespace
}  // namespace penumbra::bake
