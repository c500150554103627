#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "study/texel/estimators.h"
#include "study/texel/learned.h"

namespace penumbra::texel {
namespace {

// The share of a disc where `covers` is true, by 500 x 500 points of its square.
template <class Covers>
double supersampled(Point centre, double radius, const Covers& covers) {
  constexpr int kSide = 500;
  int inside = 0, covered = 0;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const double x = (2.0 * i + 1.0) / kSide - 1.0, y = (2.0 * j + 1.0) / kSide - 1.0;
      if (x * x + y * y >= 1.0) continue;
      ++inside;
      covered += covers(Point{centre.x + radius * x, centre.y + radius * y}) ? 1 : 0;
    }
  return static_cast<double>(covered) / inside;
}

// The texels that are covered are those right of x: 0 is between the middle ones.
Texels covered_right_of(int x) {
  Texels texels;
  for (int j = -Texels::kReach; j < Texels::kReach; ++j)
    for (int i = x; i < Texels::kReach; ++i) texels.set(i, j, true);
  return texels;
}

constexpr Point kPlaces[] = {{0.0, 0.0}, {0.3, -0.2}, {-0.5, 0.5}, {0.5, 0.1}};

TEST(TexelGeometry, AHalfPlaneCoversWhatSamplesSay) {
  for (const double radius : {0.25, 1.0})
    for (const double inside : {-1.2, -0.9, -0.3, 0.0, 0.5, 0.99, 1.5}) {
      const double sampled =
          supersampled({0.0, 0.0}, radius, [&](Point at) { return at.x > -inside * radius; });
      EXPECT_NEAR(covered_by_half_plane(inside * radius, radius), sampled, 1e-3) << inside;
    }
}

TEST(TexelGeometry, TheMeanOfParallelEdgesIsThatOfManyOfThem) {
  for (const double inside : {-0.7, 0.1, 0.6})
    for (const double reach : {1e-6, 0.2, 0.9}) {
      double mean = 0.0;
      for (int i = 0; i < 1000; ++i)
        mean += covered_by_half_plane(inside + reach * ((2 * i + 1) / 1000.0 - 1.0), 0.5) / 1000.0;
      EXPECT_NEAR(mean_covered_by_half_plane(inside, reach, 0.5), mean, 1e-5) << inside << ' ' << reach;
    }
}

TEST(TexelGeometry, SquaresOfTexelsCoverWhatSamplesSay) {
  for (const Point place : kPlaces)
    for (const double radius : {0.25, 0.9, 1.25}) {
      const std::array<double, 16> shares = shares_of_texels(place, radius);
      for (int i = 0; i < 16; ++i) {
        const int x = i % 4 - 2, y = i / 4 - 2;
        EXPECT_NEAR(
            shares[i],
            supersampled(place, radius,
                         [&](Point at) { return at.x > x && at.x < x + 1 && at.y > y && at.y < y + 1; }),
            2e-3);
      }
    }
}

TEST(TexelGeometry, LinesAcrossTheDiscTellWhatEllipsesCover) {
  Random random(5);
  double worst = 0.0, squares = 0.0;
  constexpr int kCount = 50;
  for (int i = 0; i < kCount; ++i) {
    std::vector<Ellipse> ellipses;
    for (int k = 0; k < 3; ++k) {
      const double angle = random.between(0.0, 2.0 * std::numbers::pi), major = random.between(0.5, 2.0);
      ellipses.push_back({{random.between(-1.5, 1.5), random.between(-1.5, 1.5)},
                          major,
                          major * random.between(0.3, 1.0),
                          {std::cos(angle), std::sin(angle)}});
    }
    const auto covers = [&](Point at) {
      return std::any_of(ellipses.begin(), ellipses.end(),
                         [&](const Ellipse& one) { return one.contains(at); });
    };
    const double fine = covered_by_ellipses({0.1, 0.2}, 1.0, ellipses, 4096);
    if (i < 5) {
      EXPECT_NEAR(fine, supersampled({0.1, 0.2}, 1.0, covers), 1e-3);
    }
    const double error = covered_by_ellipses({0.1, 0.2}, 1.0, ellipses, 64) - fine;
    squares += error * error / kCount;
    worst = std::max(worst, std::abs(error));
  }
  EXPECT_LT(std::sqrt(squares), 1e-3);
  EXPECT_LT(worst, 5e-3);
}

TEST(TexelShapes, CoveredTexelsAreAboutTheMeanCoverOfTheDiscs) {
  for (const Kind kind : kKinds) {
    Random random(7);
    double bits = 0.0, covered = 0.0;
    constexpr int kCount = 20'000;
    for (int i = 0; i < kCount; ++i) {
      const Receiver receiver = drawn(kind, random, 2, 24);
      bits += bilinear(receiver.place, receiver.texels) / kCount;
      covered += receiver.covered[1] / kCount;
    }
    EXPECT_NEAR(bits, covered, 0.01) << name_of(kind);
    EXPECT_GT(covered, 0.3);
    EXPECT_LT(covered, 0.6);
  }
}

TEST(TexelShapes, ABlockIsTheMiddleOfTheTexels) {
  Texels texels;
  texels.set(-2, -2, true);
  texels.set(1, 0, true);
  texels.set(2, 0, true);  // beyond the block
  EXPECT_EQ(texels.block(), 1U | 1U << 11);
  EXPECT_EQ(Texels::of_block(texels.block()).block(), texels.block());
  EXPECT_FALSE(Texels::of_block(texels.block()).covers(2, 0));
}

TEST(TexelEstimators, NothingAndEverythingAreKept) {
  for (const bool all : {false, true}) {
    const Texels texels = covered_right_of(all ? -Texels::kReach : Texels::kReach);
    const double wanted = all ? 1.0 : 0.0;
    for (const Point place : kPlaces)
      for (const double radius : kRadii) {
        EXPECT_NEAR(bilinear(place, texels), wanted, 1e-12);
        EXPECT_NEAR(disc_kernel(place, texels, radius), wanted, 1e-12);
        EXPECT_NEAR(shipped_kernel(place, texels, radius), wanted, 1e-12);
        EXPECT_NEAR(fit_of_edge(place, texels, radius, 0.9), wanted, 1e-12);
        EXPECT_NEAR(mean_fit_of_edge(place, texels, radius, 0.9), wanted, 1e-12);
        EXPECT_EQ(revectorised(place, texels, radius, 2), wanted);
        EXPECT_EQ(revectorised(place, texels, radius, Texels::kReach), wanted);
      }
  }
}

// An edge along a column of texels is known only to lie between their centres, so its middle is at 0.
TEST(TexelEstimators, AnEdgeAlongTheTexels) {
  const Texels texels = covered_right_of(0);
  const FittedEdge edge = fitted_edge(texels.block());
  EXPECT_TRUE(edge.found);
  EXPECT_NEAR(edge.normal.x, 1.0, 1e-12);
  EXPECT_NEAR(edge.offset, 0.0, 1e-12);
  EXPECT_NEAR(edge.room, 0.5, 1e-12);
  EXPECT_NEAR(edge.misfit, 0.0, 1e-12);
  for (const Point place : kPlaces)
    for (const double radius : kRadii) {
      const double exact = covered_by_half_plane(place.x, radius);
      EXPECT_NEAR(bilinear(place, texels), place.x + 0.5, 1e-12);
      EXPECT_NEAR(disc_kernel(place, texels, radius), exact, 1e-9);
      EXPECT_NEAR(fit_of_edge(place, texels, radius, 0.9), exact, 1e-9);
      EXPECT_NEAR(mean_fit_of_edge(place, texels, radius, 0.9),
                  mean_covered_by_half_plane(place.x, 0.5, radius), 1e-9);
      EXPECT_NEAR(revectorised(place, texels, radius, 2), exact, 0.03);
      EXPECT_NEAR(revectorised(place, texels, radius, Texels::kReach), exact, 0.03);
    }
}

TEST(TexelEstimators, AnEdgeIsWhereTheBitsChange) {
  const FittedEdge edge = fitted_edge(covered_right_of(1).block());
  EXPECT_NEAR(edge.offset, 1.0, 1e-12);
  EXPECT_NEAR(fit_of_edge({0.4, 0.1}, covered_right_of(1), 1.0, 0.9), covered_by_half_plane(-0.6, 1.0), 1e-9);
}

// The shipped kernel of 1 texel weighs centres at distances of .5 by .5, here and there.
TEST(TexelEstimators, TheShippedKernelWeighsByTheDistance) {
  Texels texels;
  texels.set(0, 0, true);
  EXPECT_NEAR(shipped_kernel({0.0, 0.0}, texels, 1.0), 0.25, 1e-12);
  const double outermost = 1.4;
  const auto weight = [&](double x, double y) { return std::max(1.0 - std::hypot(x, y) / outermost, 0.0); };
  double all = 0.0;
  for (int y = -2; y < 2; ++y)
    for (int x = -2; x < 2; ++x) all += weight(x + 0.5 - 0.5, y + 0.5 - 0.5);
  EXPECT_NEAR(shipped_kernel({0.5, 0.5}, texels, 1.0), 1.0 / all, 1e-12);
}

// Where no line parts the bits, only the kernel is left.
TEST(TexelEstimators, WhatNoEdgeFitsIsTheKernel) {
  const Texels texels = Texels::of_block(0x0063);  // two separate corners
  EXPECT_GT(fitted_edge(texels.block()).misfit, 0.25);
  EXPECT_NEAR(fit_of_edge({0.2, 0.1}, texels, 0.5, 0.9), disc_kernel({0.2, 0.1}, texels, 0.9), 1e-12);
}

// The stairs have one step to the side in each row, or one in four; a straight edge takes the border's place.
TEST(TexelEstimators, RevectorisedStairsAreStraight) {
  for (const int step : {1, 4}) {
    const auto covers = [&](Point at) { return at.y + (step == 1 ? 0.5 : 0.25) < at.x / step; };
    Texels texels;
    for (int y = -Texels::kReach; y < Texels::kReach; ++y)
      for (int x = -Texels::kReach; x < Texels::kReach; ++x)
        if (covers({x + 0.5, y + 0.5})) texels.set(x, y, true);
    const double exact = supersampled({0.1, -0.1}, 1.0, covers);
    EXPECT_NEAR(revectorised({0.1, -0.1}, texels, 1.0, Texels::kReach), exact, 0.06) << step;
  }
}

// The border steps up to either side of four texels: the line between them rises from (-2, -.5) to (2, .5).
TEST(TexelEstimators, ABorderIsALineBetweenItsEnds) {
  Texels texels;
  for (int x = -Texels::kReach; x < Texels::kReach; ++x)
    for (int y = -Texels::kReach; y < (x < -2 ? -1 : x < 2 ? 0 : 1); ++y) texels.set(x, y, true);
  for (const double x : {-1.5, -0.5, 0.5, 1.5}) {
    EXPECT_TRUE(covers_revectorised(texels, {x, 0.25 * x - 0.05}, Texels::kReach)) << x;
    EXPECT_FALSE(covers_revectorised(texels, {x, 0.25 * x + 0.05}, Texels::kReach)) << x;
    EXPECT_TRUE(covers_revectorised(texels, {x, -0.05}, 2)) << x;  // its ends are out of sight
    EXPECT_FALSE(covers_revectorised(texels, {x, 0.05}, 2)) << x;
  }
}

TEST(TexelLearned, AReceiverSeenInAMirrorIsTheSame) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Receiver receiver = drawn(Kind::kLeaves, random, 2, 8);
    Texels mirrored, swapped;
    for (int y = -2; y < 2; ++y)
      for (int x = -2; x < 2; ++x) {
        mirrored.set(-1 - x, y, receiver.texels.covers(x, y));
        swapped.set(y, x, receiver.texels.covers(x, y));
      }
    const Canonical seen = canonical(receiver.place, receiver.texels.block());
    EXPECT_EQ(canonical({-receiver.place.x, receiver.place.y}, mirrored.block()).block, seen.block);
    EXPECT_EQ(canonical({receiver.place.y, receiver.place.x}, swapped.block()).block, seen.block);
    EXPECT_NEAR(disc_kernel(seen.place, Texels::of_block(seen.block), 0.9),
                disc_kernel(receiver.place, receiver.texels, 0.9), 1e-12);
  }
}

TEST(TexelLearned, ABlockOfManyReceiversIsTheirMeanAndOneOfNoneTheKernel) {
  TrainingSums sums(false);
  Random random(2);
  Receiver receiver{};
  receiver.texels = covered_right_of(0);
  for (int i = 0; i < 10'000; ++i) {
    receiver.place = {random.between(0.0, 0.5), 0.0};
    receiver.place.y = random.between(0.0, receiver.place.x);
    receiver.covered = {0.3, 0.4 * receiver.place.x, 0.5};
    sums.add(receiver);
  }
  const Learned learned(sums);
  const Point place{0.3, 0.2};
  EXPECT_NEAR(learned.covered(place, receiver.texels.block(), 0), 0.3, 0.01);
  EXPECT_NEAR(learned.covered(place, receiver.texels.block(), 1), 0.12, 0.01);
  EXPECT_NEAR(learned.covered(place, 0x0660, 1),
              shipped_kernel(place, Texels::of_block(0x0660), learned_kernel(1)), 1e-9);
}

}  // namespace
}  // namespace penumbra::texel
