// Tests the colours of pictures, as people with each kind of colour vision see them.
#include <gtest/gtest.h>

#include "resolve/colour_vision.h"
#include "study/colour_map.h"

namespace penumbra::study {
namespace {

using colour_vision::kKinds;
using colour_vision::least_difference;
using colour_vision::seen;

glm::dvec3 unit(Rgb colour) {
  return glm::dvec3(colour.r, colour.g, colour.b) / 255.0;
}

TEST(ColourVision, GreysStayGreyAndPrimariesDoNot) {
  for (const glm::dmat3& kind : kKinds) {
    const glm::dvec3 grey = seen(glm::dvec3(0.5), kind);
    EXPECT_LT(std::abs(grey.y) + std::abs(grey.z), 1.0) << "rows sum to one";
    EXPECT_NEAR(grey.x, 53.4, 0.2);
  }
  // Red and green of the same lightness are near each other for two kinds in three.
  EXPECT_GT(glm::distance(seen({0.8, 0.2, 0.2}, kKinds[0]), seen({0.2, 0.55, 0.2}, kKinds[0])), 80.0);
  EXPECT_LT(glm::distance(seen({0.72, 0.45, 0.2}, kKinds[2]), seen({0.42, 0.62, 0.2}, kKinds[2])), 25.0);
}

TEST(ColourVision, TheSignOfAnErrorIsPlainForAll) {
  EXPECT_GT(least_difference(unit(error_colour(-1.0)), unit(error_colour(1.0))), 60.0);
  for (int i = 1; i <= 10; ++i) {
    const double share = i / 10.0;
    EXPECT_GT(least_difference(unit(error_colour(-share)), unit(error_colour(share))), 60.0 * share * 0.8)
        << share;
    EXPECT_GT(least_difference(unit(error_colour(share)), unit(error_colour(0.0))), 40.0 * share * 0.8)
        << share;
    EXPECT_GT(least_difference(unit(error_colour(-share)), unit(error_colour(0.0))), 40.0 * share * 0.8)
        << share;
  }
}

TEST(ColourVision, MoreFetchesAreLighterForAll) {
  for (const glm::dmat3& kind : kKinds) {
    double last = -1.0;
    for (int i = 0; i <= 20; ++i) {
      const double lightness = seen(unit(fetch_colour(i / 20.0)), kind).x;
      // There are some 78 steps of lightness over the whole: none of twenty parts is flat, none a leap.
      EXPECT_GT(lightness, last + 2.0) << i;
      EXPECT_LT(lightness, i > 0 ? last + 6.5 : 20.0) << i;
      last = lightness;
    }
    EXPECT_GT(last, 85.0);
  }
}

TEST(ColourVision, CategoriesAreApartForAll) {
  const Category all[] = {Category::orange, Category::sky_blue,   Category::bluish_green,  Category::yellow,
                          Category::blue,   Category::vermillion, Category::reddish_purple};
  for (const Category a : all) {
    for (const Category b : all) {
      if (a < b) {
        EXPECT_GT(least_difference(unit(category_colour(a)), unit(category_colour(b))), 10.0)
            << static_cast<int>(a) << " " << static_cast<int>(b);
      }
    }
  }
}

}  // namespace
}  // namespace penumbra::study
