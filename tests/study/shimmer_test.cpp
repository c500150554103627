#include "study/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace penumbra::study {
namespace {

constexpr int kWidth = 6;

// The camera slides over two rows of this world.
float world(int column, int row) {
  return 0.1F + 0.1F * float(column) + (row == 1 ? 0.05F : 0.0F);
}

std::vector<float> picture(int moved) {
  std::vector<float> frame;
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < kWidth; ++column) frame.push_back(world(column + moved, row));
  }
  return frame;
}

struct Pan {
  std::vector<std::vector<float>> frames{picture(0), picture(1), picture(2)};
  std::vector<float> t1 = std::vector<float>(2 * kWidth, 0.5F);
  std::vector<std::uint8_t> valid = std::vector<std::uint8_t>(2 * kWidth, 1);

  std::optional<double> shimmer() const { return shimmer_of(frames, kWidth, t1, valid); }
};

TEST(Shimmer, APictureThatOnlySlidesDoesNotFlicker) {
  EXPECT_NEAR(Pan().shimmer().value(), 0.0, 1e-7);
}

TEST(Shimmer, IsTheRmsChangeOfTheSamePoint) {
  Pan pan;
  // World column 3 of row 0 stands in columns 3, 2, 1: 0.4, then 0.4 + 0.3, then 0.4 again. Four points of
  // each row stay in the picture for both changes.
  pan.frames[1][2] += 0.3F;
  EXPECT_NEAR(pan.shimmer().value(), std::sqrt(2.0 * 0.09 / 16.0), 1e-6);
}

TEST(Shimmer, CountsPenumbraPointsWithAReceiverThatStayInThePicture) {
  Pan pan;
  pan.frames[2][5] = 1.0F;  // world column 7 is not in the first picture
  pan.frames[1][0] = 0.9F;  // world column 1 leaves before the last
  EXPECT_NEAR(pan.shimmer().value(), 0.0, 1e-7);
  pan.frames[1][2] += 0.3F;
  pan.valid[3] = 0;
  EXPECT_NEAR(pan.shimmer().value(), 0.0, 1e-7);
  pan.valid[3] = 1;
  pan.t1[3] = 1.0F;
  EXPECT_NEAR(pan.shimmer().value(), 0.0, 1e-7);
  pan.t1.assign(pan.t1.size(), 0.0F);
  EXPECT_FALSE(pan.shimmer());
}

TEST(Shimmer, PicturesOfDifferentSizeAreRefused) {
  Pan pan;
  pan.frames[1].pop_back();
  EXPECT_THROW((void)pan.shimmer(), std::invalid_argument);
  pan.frames = {picture(0)};
  EXPECT_FALSE(pan.shimmer()) << "one frame has nothing to change from";
  pan.t1.pop_back();
  EXPECT_THROW((void)pan.shimmer(), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::study
