#include "study/metrics.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

namespace penumbra::study {
namespace {

constexpr double kFloatExact = 1e-12;  // the test's values are binary fractions: only sums can round

// Ten pixels, one of them without a receiver, with figures small enough to be worked out by hand.
//   pixel     0     1      2     3     4     5     6     7     8    9 (no receiver)
//   class    umbra umbra  pen.  pen.  pen.  pen.  lit   lit   lit   -
struct HandMade {
  std::vector<float> t1{0.0F, 0.0F, 0.25F, 0.5F, 0.5F, 0.75F, 1.0F, 1.0F, 1.0F, 0.5F};
  std::vector<std::uint8_t> valid{1, 1, 1, 1, 1, 1, 1, 1, 1, 0};
  std::vector<float> seed0{0.0F, 0.25F, 0.5F, 0.5F, 0.25F, 0.75F, 1.0F, 0.5F, 1.0F, 0.0F};
  std::vector<float> seed1{0.0F, 0.0F, 0.25F, 0.5F, 0.75F, 0.5F, 1.0F, 1.0F, 1.0F, 1.0F};
  std::vector<std::uint32_t> fetches{1, 1, 9, 9, 9, 9, 1, 1, 5, 1000};

  MeasuredImages images() const {
    MeasuredImages images;
    images.t1 = t1;
    images.valid = valid;
    images.results = {seed0, seed1};
    images.fetches = {fetches};
    images.preprocess_fetches_per_pixel = 0.5;
    return images;
  }
};

// Images of pixels that all have receivers.
struct Plain {
  std::vector<float> t1, result;
  std::vector<std::uint8_t> valid = std::vector<std::uint8_t>(t1.size(), 1);

  MeasuredImages images() const {
    MeasuredImages images;
    images.t1 = t1;
    images.valid = valid;
    images.results = {result};
    return images;
  }
};

TEST(Metrics, CountOnlyPixelsWithAReceiver) {
  const HandMade made;
  const Metrics metrics = measure(made.images());
  EXPECT_EQ(metrics.pixels, 9U);
  EXPECT_EQ(metrics.penumbra_pixels, 4U);
  EXPECT_EQ(metrics.seeds, 2U);
  EXPECT_EQ(metrics.invalid, 0U);
}

TEST(Metrics, ErrorsAreThoseWorkedOutByHand) {
  const HandMade made;
  const Metrics metrics = measure(made.images());
  // The errors in penumbrae are +1/4, 0, -1/4, 0 with seed 0, and 0, 0, +1/4, -1/4 with seed 1.
  EXPECT_NEAR(metrics.rmse_penumbra.value(), std::sqrt(4.0 / 16.0 / 8.0), kFloatExact);
  EXPECT_NEAR(metrics.bias.value(), 0.0, kFloatExact);
  // Elsewhere they are +1/4 in the umbra, and -1/2 in the light.
  EXPECT_NEAR(metrics.rmse_all.value(), std::sqrt((5.0 / 16.0 + 1.0 / 4.0) / 18.0), kFloatExact);
  EXPECT_NEAR(metrics.max_error.value(), 0.5, kFloatExact);
  EXPECT_NEAR(metrics.p99.value(), 0.25, kFloatExact);
  EXPECT_NEAR(metrics.leak_rate.value(), 1.0 / 4.0, kFloatExact);
  EXPECT_NEAR(metrics.false_shadow_rate.value(), 1.0 / 6.0, kFloatExact);
}

// Half of the picture errs by 1/2, half not at all; there are blocks of four pixels, 32 across, in one row.
TEST(Metrics, IntervalsAreDrawnFromBlocksOfThePicture) {
  Plain made{std::vector<float>(128 * 4, 0.5F), std::vector<float>(128 * 4, 0.5F)};
  for (std::size_t pixel = 0; pixel < made.result.size(); ++pixel)
    if (pixel % 128 < 64) made.result[pixel] = 1.0F;
  MeasuredImages images = made.images();
  EXPECT_FALSE(measure(images).intervals.rmse_penumbra) << "without a width there is one block";
  images.width = 128;
  const Interval interval = measure(images).intervals.rmse_penumbra.value();
  // The mean square is 1/8 with a standard error of 1/8 / sqrt(32); its root's follows by the chain rule.
  EXPECT_NEAR(interval.standard_error, 0.125 / std::sqrt(32.0) / (2.0 * std::sqrt(0.125)), 0.003);
  EXPECT_FALSE(measure(images).intervals.leak_rate) << "no umbra";
  images.width = 100;
  EXPECT_THROW(measure(images), std::invalid_argument);
}

TEST(Metrics, AMaskIsJudgedByWhatItSavesAndWhatItMisses) {
  const HandMade made;
  EXPECT_FALSE(measure(made.images()).mask);
  // The mask leaves out five of nine pixels, one of the four in penumbra; the pixel without a receiver counts
  // nowhere.
  const std::vector<std::uint8_t> masked_out{1, 1, 0, 0, 1, 0, 1, 1, 0, 1};
  MeasuredImages images = made.images();
  images.masked_out = masked_out;
  const std::optional<MaskShares> mask = measure(images).mask;
  ASSERT_TRUE(mask);
  EXPECT_NEAR(mask->pixels_saved, 5.0 / 9.0, kFloatExact);
  EXPECT_NEAR(mask->penumbra_pixels_missed.value(), 1.0 / 4.0, kFloatExact);
  const std::vector<float> all_lit(10, 1.0F);
  images.t1 = all_lit;
  EXPECT_FALSE(measure(images).mask->penumbra_pixels_missed) << "no penumbra to miss";
  images.masked_out = images.masked_out.first(9);
  EXPECT_THROW(measure(images), std::invalid_argument) << "of another size";
}

TEST(Metrics, VarianceIsThatOfTheSeedsAlone) {
  const HandMade made;
  // Two values a, b have the sample variance (a-b)^2/2. In penumbrae these are 1/32, 0, 1/8, 1/32.
  EXPECT_NEAR(measure(made.images()).variance.value(), (1.0 / 32 + 1.0 / 8 + 1.0 / 32) / 4.0, kFloatExact);

  // A technique that is wrong but steady has no variance.
  MeasuredImages steady = made.images();
  steady.results = {made.seed0, made.seed0, made.seed0};
  EXPECT_EQ(measure(steady).variance, 0.0);
  EXPECT_GT(measure(steady).rmse_penumbra.value(), 0.1);
}

TEST(Metrics, OneSeedHasNoVariance) {
  const HandMade made;
  MeasuredImages images = made.images();
  images.results = {made.seed0};
  EXPECT_FALSE(measure(images).variance.has_value());
  EXPECT_TRUE(measure(images).rmse_penumbra.has_value());
}

TEST(Metrics, BiasIsPositiveWhenTooBright) {
  HandMade made;
  made.seed0[3] = 1.0F;
  EXPECT_NEAR(measure(made.images()).bias.value(), 0.5 / 8.0, kFloatExact);
}

TEST(Metrics, FetchesOfSkyDoNotCount) {
  const HandMade made;
  const Metrics metrics = measure(made.images());
  EXPECT_NEAR(metrics.fetches_mean.value(), 45.0 / 9.0, kFloatExact);
  EXPECT_NEAR(metrics.fetches_penumbra_mean.value(), 9.0, kFloatExact);
  EXPECT_EQ(metrics.fetches_p95, 9.0);
  EXPECT_EQ(metrics.preprocess_fetches_per_pixel, 0.5);
}

TEST(Metrics, PercentilesAreNearestRank) {
  // The 100 penumbra pixels have absolute errors 0.000, 0.005 ... 0.495 in a scrambled order: rank 99 is
  // 0.490.
  Plain made{std::vector<float>(100, 0.5F), std::vector<float>(100)};
  std::vector<std::uint32_t> fetches(100);
  for (std::size_t i = 0; i < 100; ++i) {
    const std::size_t place = i * 37 % 100;
    made.result[place] = 0.5F + (i % 2 == 0 ? 1.0F : -1.0F) * static_cast<float>(i) / 200.0F;
    fetches[place] = static_cast<std::uint32_t>(i) + 1;
  }
  MeasuredImages images = made.images();
  images.fetches = {fetches};
  const Metrics metrics = measure(images);
  EXPECT_NEAR(metrics.p99.value(), 0.490, 1e-6);  // the results are floats
  EXPECT_EQ(metrics.fetches_p95, 95.0);
}

TEST(Metrics, AnEmptyClassHasNoFigureInsteadOfZero) {
  const Plain lit{std::vector<float>(4, 1.0F), std::vector<float>(4, 1.0F)};
  MeasuredImages images = lit.images();
  images.results.push_back(lit.result);
  const Metrics metrics = measure(images);
  EXPECT_EQ(metrics.penumbra_pixels, 0U);
  EXPECT_FALSE(metrics.rmse_penumbra.has_value());
  EXPECT_FALSE(metrics.bias.has_value());
  EXPECT_FALSE(metrics.variance.has_value());
  EXPECT_FALSE(metrics.p99.has_value());
  EXPECT_FALSE(metrics.leak_rate.has_value());
  EXPECT_FALSE(metrics.fetches_mean.has_value());
  EXPECT_EQ(metrics.rmse_all, 0.0);
  EXPECT_EQ(metrics.false_shadow_rate, 0.0);
}

TEST(Metrics, ClassBoundsAreThoseOfTheDefinition) {
  // 0.1F is above 0.1 and 0.9F below 0.9: a leak, a shadow.
  const Plain just{{std::nextafter(0.02F, 0.0F), std::nextafter(0.02F, 1.0F), std::nextafter(0.98F, 0.0F),
                    std::nextafter(0.98F, 1.0F)},
                   {0.1F, 0.5F, 0.5F, 0.9F}};
  MeasuredImages images = just.images();
  const Metrics metrics = measure(images);
  EXPECT_EQ(metrics.penumbra_pixels, 2U);
  EXPECT_EQ(metrics.leak_rate, 1.0);
  EXPECT_EQ(metrics.false_shadow_rate, 1.0);

  const std::vector<float> inside{std::nextafter(0.1F, 0.0F), 0.5F, 0.5F, std::nextafter(0.9F, 1.0F)};
  images.results = {inside};
  EXPECT_EQ(measure(images).leak_rate, 0.0);
  EXPECT_EQ(measure(images).false_shadow_rate, 0.0);
}

TEST(Metrics, InvalidResultsAreCountedAndEnterNoFigure) {
  const HandMade made;
  const Metrics clean = measure(made.images());
  HandMade broken = made;
  broken.seed0[0] = std::numeric_limits<float>::quiet_NaN();
  broken.seed0[6] = std::numeric_limits<float>::infinity();
  broken.seed1[6] = 1.5F;
  broken.seed1[2] = -0.25F;
  broken.seed0[9] = std::numeric_limits<float>::quiet_NaN();  // nobody looks where there is no receiver
  const Metrics metrics = measure(broken.images());
  EXPECT_EQ(metrics.invalid, 4U);
  // Three of the four lost a zero error, so the same squares stand over fewer values.
  EXPECT_NEAR(metrics.rmse_penumbra.value(), clean.rmse_penumbra.value() * std::sqrt(8.0 / 7.0), kFloatExact);
  EXPECT_NEAR(metrics.rmse_all.value(), clean.rmse_all.value() * std::sqrt(18.0 / 14.0), kFloatExact);
  EXPECT_NEAR(metrics.false_shadow_rate.value(), 1.0 / 4.0, kFloatExact);
}

class Split : public testing::Test {
 protected:
  void SetUp() override {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> visibility(0.0F, 1.0F);
    for (std::vector<float>* image : {&t1_, &t2_, &t3_, &seed0_, &seed1_}) {
      image->resize(1000);
      for (float& value : *image) value = visibility(random);
    }
    images_.t1 = t1_;
    images_.t2 = t2_;
    images_.t3 = t3_;
    images_.valid = valid_;
    images_.results = {seed0_, seed1_};
  }

  std::vector<float> t1_, t2_, t3_, seed0_, seed1_;
  std::vector<std::uint8_t> valid_ = std::vector<std::uint8_t>(1000, 1);
  MeasuredImages images_;
};

TEST_F(Split, MeansAddUpToTheBias) {
  const Metrics metrics = measure(images_);
  EXPECT_NEAR(metrics.split.map->mean + metrics.split.algorithm->mean + metrics.split.sampling->mean,
              metrics.bias.value(), 1e-12);
  // RMSEs of independent errors do not add up: nobody may read one as the difference of two others.
  EXPECT_GT(metrics.split.map->rmse + metrics.split.algorithm->rmse, metrics.rmse_penumbra.value() + 0.1);
}

TEST_F(Split, EachShareIsTheDifferenceOfItsImages) {
  images_.t3 = images_.t2;
  EXPECT_EQ(measure(images_).split.algorithm, (ErrorShare{0.0, 0.0}));
  images_.t2 = images_.t1;
  EXPECT_EQ(measure(images_).split.map, (ErrorShare{0.0, 0.0}));
  images_.t3 = images_.t1;
  const Metrics metrics = measure(images_);
  EXPECT_NEAR(metrics.split.sampling->rmse, metrics.rmse_penumbra.value(), 1e-12);
  EXPECT_NEAR(metrics.split.sampling->mean, metrics.bias.value(), 1e-12);
}

TEST_F(Split, SignsSayWhichWay) {
  const std::vector<float> dark(1000, 0.25F);
  const std::vector<float> middle(1000, 0.5F);
  images_.t1 = middle;
  images_.t2 = dark;
  images_.t3 = middle;
  images_.results = {dark};
  const Metrics metrics = measure(images_);
  EXPECT_EQ(metrics.split.map, (ErrorShare{-0.25, 0.25}));
  EXPECT_EQ(metrics.split.algorithm, (ErrorShare{0.25, 0.25}));
  EXPECT_EQ(metrics.split.sampling, (ErrorShare{-0.25, 0.25}));
}

TEST_F(Split, IsAbsentWithoutItsReferences) {
  images_.t2 = {};
  EXPECT_FALSE(measure(images_).split.map.has_value());
  EXPECT_FALSE(measure(images_).split.algorithm.has_value());
  EXPECT_TRUE(measure(images_).split.sampling.has_value());
  images_.t3 = {};
  EXPECT_FALSE(measure(images_).split.sampling.has_value());
}

TEST_F(Split, AnInvalidUnlimitedResultIsAFindingToo) {
  t3_[5] = std::numeric_limits<float>::quiet_NaN();
  t1_[5] = 0.5F;
  const Metrics metrics = measure(images_);
  EXPECT_EQ(metrics.invalid, 1U);
  EXPECT_TRUE(std::isfinite(metrics.split.sampling->rmse));
}

TEST_F(Split, ABrokenReferenceIsRefused) {
  t2_[17] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(measure(images_), std::invalid_argument);
  t2_[17] = 0.5F;
  t1_[17] = 1.25F;
  EXPECT_THROW(measure(images_), std::invalid_argument);
  valid_[17] = 0;
  EXPECT_NO_THROW(measure(images_));
}

TEST_F(Split, ImagesOfDifferentSizeAreRefused) {
  images_.results[1] = images_.results[1].first(999);
  EXPECT_THROW(measure(images_), std::invalid_argument);
  images_.results.clear();
  EXPECT_THROW(measure(images_), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::study
