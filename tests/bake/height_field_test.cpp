#include "bake/height_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "bake/made_fields.h"
#include "input/input_error.h"

namespace penumbra::bake {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr Area kArea{{-3.0, 10.0}, {6.0, 2.0}};

// A product of linear functions is bilinear, so the field meets it everywhere.
TEST(HeightField, IsBilinearBetweenItsSamples) {
  const auto height = [](glm::dvec2 at) { return (1.0 + 2.0 * at.x) * (3.0 - at.y); };
  const HeightField field = made_field(4, 3, kArea, height);
  for (double x = -3.0; x <= 3.0; x += 0.37) {
    for (double z = 10.0; z <= 12.0; z += 0.23) EXPECT_NEAR(field.height({x, z}), height({x, z}), 1e-12);
  }
}

TEST(HeightField, GoesOnLevelOutsideOfItsArea) {
  const HeightField field = rough_field(5, 4, kArea, 1);
  EXPECT_EQ(field.height({-100.0, 11.0}), field.height({-3.0, 11.0}));
  EXPECT_EQ(field.height({0.5, 1e9}), field.height({0.5, 12.0}));
  EXPECT_EQ(field.height({3.0, 12.0}), field.at(4, 3));
}

TEST(HeightField, SaysWhatIsWrongWithIt) {
  const HeightField good = rough_field(5, 4, kArea, 1);
  EXPECT_NO_THROW(check_height_field(good));
  const auto refused = [&](auto change) {
    HeightField field = good;
    change(field);
    return [field] { check_height_field(field); };
  };
  EXPECT_THAT(refused([](HeightField& field) { field.width = 1; }),
              ThrowsMessage<InputError>(HasSubstr("from 2 to 8193 samples per side, not 1")));
  EXPECT_THAT(refused([](HeightField& field) { field.depth = 16385; }),
              ThrowsMessage<InputError>(HasSubstr("not 16385")));
  EXPECT_THAT(refused([](HeightField& field) { field.metres.pop_back(); }),
              ThrowsMessage<InputError>(HasSubstr("5 x 4 samples cannot have 19 heights")));
  EXPECT_THAT(refused([](HeightField& field) { field.area.size.y = -2.0; }),
              ThrowsMessage<InputError>(HasSubstr("cannot cover 6 x -2 metres")));
  EXPECT_THAT(refused([](HeightField& field) { field.metres[7] = std::numeric_limits<float>::quiet_NaN(); }),
              ThrowsMessage<InputError>(HasSubstr("column 2, row 1 is not a finite number")));
}

}  // namespace
}  // namespace penumbra::bake
