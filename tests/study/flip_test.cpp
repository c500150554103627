// FLIP against values that the authors' own implementation (FLIP.h of github.com/NVlabs/flip, commit
// 1eb247ca) gives for the same pictures, which a formula makes.
#include "study/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace penumbra::study {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 64;

enum class Made { ramp, disc, checks, other_checks, stripes };

std::vector<glm::vec3> made(Made kind) {
  std::vector<glm::vec3> colours;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      glm::vec3 colour((static_cast<float>(x) + 0.5F) / kWidth, (static_cast<float>(y) + 0.5F) / kHeight,
                       0.5F);
      const bool odd = (x / 8 + y / 8) % 2 == 1;
      const glm::vec3 green(0.0F, 1.0F, 0.0F), blue(0.0F, 0.0F, 1.0F);
      if (kind == Made::disc && (x - 40) * (x - 40) + (y - 30) * (y - 30) <= 225) colour *= 0.25F;
      if (kind == Made::checks) colour = odd ? green : blue;
      if (kind == Made::other_checks) colour = odd ? blue : green;
      if (kind == Made::stripes) {
        colour.x *= 0.9F;
        colour.z += static_cast<float>((x * 7 + y * 13) % 5) * 0.05F;
      }
      colours.push_back(colour);
    }
  return colours;
}

struct Expected {
  Made reference;
  Made test;
  double mean;
  double corner;  // of the pixel above left
  double middle;  // of the pixel in the middle of the disc
};

TEST(Flip, IsThatOfItsAuthors) {
  for (const Expected& expected : {Expected{Made::ramp, Made::disc, 0.1126506, 0.0, 0.826727},
                                   {Made::ramp, Made::stripes, 0.3091179, 0.251414, 0.254520},
                                   {Made::checks, Made::other_checks, 0.9238841, 0.999156, 0.815213},
                                   {Made::disc, Made::stripes, 0.3931618, 0.251414, 0.903608}}) {
    const std::vector<glm::vec3> colours = made(expected.reference), others = made(expected.test);
    const FlipReference reference({kWidth, kHeight, colours});
    const std::vector<float> differences = reference.differences({kWidth, kHeight, others});
    EXPECT_NEAR(reference.mean_difference({kWidth, kHeight, others}), expected.mean, 2e-5);
    EXPECT_NEAR(differences.front(), expected.corner, 2e-5);
    EXPECT_NEAR(differences[30 * kWidth + 40], expected.middle, 3e-5);
  }
}

TEST(Flip, OfEqualPicturesIsNothing) {
  const std::vector<glm::vec3> colours = made(Made::stripes);
  EXPECT_EQ(FlipReference({kWidth, kHeight, colours}).mean_difference({kWidth, kHeight, colours}), 0.0);
}

TEST(Flip, ComparesPicturesOfOneSize) {
  const std::vector<glm::vec3> colours = made(Made::ramp);
  const FlipReference reference({kWidth, kHeight, colours});
  EXPECT_THROW((void)reference.differences({kHeight, kWidth, colours}), std::invalid_argument);
  EXPECT_THROW(FlipReference({kWidth, kHeight + 1, colours}), std::invalid_argument);
  EXPECT_THROW(FlipReference({0, 0, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::study
